#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <scree/error.hpp>

namespace scree::formula {

// What is wrong with a formula, "problem; cure", and where: bytes before it in the text.
struct FormulaError : Error {
  FormulaError(std::size_t place_in_text, const std::string& problem, const std::string& cure)
      : Error("", problem, cure), at(place_in_text) {}
  std::size_t at;
};

// What an instruction puts on the stack, or does with the one or two numbers on top of it.
enum class Operation { constant, name, of_one, of_two };

struct Instruction {
  Operation operation;
  double constant = 0;    // of a constant
  std::size_t index = 0;  // in Formula::names, functions_of_one() or functions_of_two()
  std::size_t at = 0;     // place in the text, for messages
};

// "<probe>.<column>" or "time"
struct Name {
  std::string text;
  std::size_t at;  // bytes before it
};

// A formula as instructions for a stack, each after those whose results it takes.
struct Formula {
  std::vector<Instruction> instructions;
  std::vector<Name> names;  // each once, in the order of the text
};

struct FunctionOfOne {
  const char* name;
  double (*value)(double);
};
struct FunctionOfTwo {
  const char* name;  // or sign
  double (*value)(double, double);
};
std::span<const FunctionOfOne> functions_of_one();  // the first is the minus sign
std::span<const FunctionOfTwo> functions_of_two();  // the first five are + - * / ^

// Reads a formula: numbers, pi, time, names, parentheses, + - * / ^ and functions. From strong to weak: ^,
// from right to left; the minus sign, so that -a^2 = -(a^2); * and /; + and -, both from left to right. A
// name consists of letters, digits, '_' and dots, or of anything in single quotes. Throws FormulaError.
Formula parse(std::string_view text);

// The value of a formula. names: the values of its names.
double value(const Formula& formula, std::span<const double> names);

// A formula as numbers, and back, without places and names. slots: in which of the numbers given to value()
// its names are.
std::vector<double> encoded(const Formula& formula, std::span<const std::size_t> slots);
Formula decoded(std::span<const double> numbers);

}  // namespace scree::formula
