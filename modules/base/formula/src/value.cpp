#include <algorithm>

#include <scree/formula/formula.hpp>

namespace scree::formula {

double value(const Formula& formula, std::span<const double> names) {
  std::vector<double> stack;
  for (const Instruction& instruction : formula.instructions) {
    switch (instruction.operation) {
      case Operation::constant:
        stack.push_back(instruction.constant);
        break;
      case Operation::name:
        stack.push_back(names[instruction.index]);
        break;
      case Operation::of_one:
        stack.back() = functions_of_one()[instruction.index].value(stack.back());
        break;
      case Operation::of_two: {
        const double last = stack.back();
        stack.pop_back();
        stack.back() = functions_of_two()[instruction.index].value(stack.back(), last);
      }
    }
  }
  return stack.back();
}

// Two numbers for each instruction: what it is, and its constant or index.
std::vector<double> encoded(const Formula& formula, std::span<const std::size_t> slots) {
  std::vector<double> numbers;
  for (const Instruction& instruction : formula.instructions) {
    numbers.push_back(double(instruction.operation));
    switch (instruction.operation) {
      case Operation::constant:
        numbers.push_back(instruction.constant);
        break;
      case Operation::name:
        numbers.push_back(double(slots[instruction.index]));
        break;
      default:
        numbers.push_back(double(instruction.index));
    }
  }
  return numbers;
}

Formula decoded(std::span<const double> numbers) {
  Formula formula;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) {
    Instruction instruction = {Operation(int(numbers[k]))};
    if (instruction.operation == Operation::constant)
      instruction.constant = numbers[k + 1];
    else
      instruction.index = std::size_t(numbers[k + 1]);
    formula.instructions.push_back(instruction);
  }
  return formula;
}

}  // namespace scree::formula
