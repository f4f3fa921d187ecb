#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/format.h>

#include <scree/formula/units.hpp>

namespace scree::formula {

namespace {

constexpr const char* unit_cure =
    "give the quantity its unit, as { formula = \"...\", unit = \"Pa\" }, if this is meant";

// Powers of units: Pa/m is {Pa: 1, m: -1}.
using Powers = std::map<std::string, double>;

void multiply_powers(Powers& powers, const Powers& others, double exponent) {
  for (const auto& [unit, power] : others)
    if ((powers[unit] += exponent * power) == 0) powers.erase(unit);
}

struct NamedUnit {
  const char* name;
  double kg, m, s;
};
constexpr NamedUnit named_units[] = {{"N", 1, 1, -2}, {"Pa", 1, -1, -2}, {"J", 1, 2, -2},
                                     {"W", 1, 2, -3}, {"Hz", 0, 0, -1},  {"rad", 0, 0, 0}};

// In base units, in which equal units look the same.
Powers in_base(const Powers& powers) {
  Powers base;
  for (const auto& [unit, power] : powers) {
    const std::string& name_of_unit = unit;  // clang captures no parts of a pair
    const auto found = std::find_if(std::begin(named_units), std::end(named_units),
                                    [&](const NamedUnit& named) { return name_of_unit == named.name; });
    if (found == std::end(named_units))
      multiply_powers(base, {{unit, 1}}, power);
    else
      for (const auto& [name, of_named] : {std::pair{"kg", found->kg}, {"m", found->m}, {"s", found->s}})
        multiply_powers(base, {{name, 1}}, power * of_named);
  }
  return base;
}

// Reads "m" or "m^2" at a place of the text, behind which the place then is; false if there is none. side: -1
// below the stroke.
bool read_factor(std::string_view text, double side, std::size_t& at, Powers& powers) {
  std::size_t end = at;
  while (end < text.size() && (std::isalpha((unsigned char)text[end]) || (unsigned char)text[end] >= 0x80))
    ++end;
  if (end == at) return false;
  const std::string unit(text.substr(at, end - at));
  double power = 1;
  if (end < text.size() && text[end] == '^') {
    const auto [stop, failure] = std::from_chars(text.data() + end + 1, text.data() + text.size(), power);
    if (failure != std::errc()) return false;
    end = std::size_t(stop - text.data());
  }
  multiply_powers(powers, {{unit, 1}}, side * power);
  at = end;
  return true;
}

// Reads units as columns have them: "m^2/s", "kg m/s", "J/(m s)", "1/s"; nothing if the text is another.
std::optional<Powers> read_unit(std::string_view text) {
  Powers powers;
  double side = 1;
  bool in_parentheses = false;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ' ' || (c == '1' && at == 0)) {
      ++at;
    } else if (c == '/' && side > 0) {
      side = -1, ++at;
      in_parentheses = at < text.size() && text[at] == '(';
      at += in_parentheses;
    } else if (c == ')' && in_parentheses) {
      side = 1, in_parentheses = false, ++at;
    } else {
      if (!read_factor(text, side, at, powers)) return std::nullopt;
      if (!in_parentheses) side = 1;
    }
  }
  return in_parentheses ? std::nullopt : std::optional(powers);
}

std::string unit_text(const Powers& powers) {
  std::string above, below;
  std::size_t count_below = 0;
  for (const auto& [unit, power] : powers) {
    std::string& side = power > 0 ? above : below;
    count_below += power < 0;
    if (!side.empty()) side += ' ';
    side += std::abs(power) == 1 ? unit : fmt::format("{}^{:g}", unit, std::abs(power));
  }
  if (below.empty()) return above;
  if (count_below > 1) below = '(' + below + ')';
  return (above.empty() ? "1" : above) + '/' + below;
}

// What is known of a number on the stack.
struct Dimension {
  std::optional<double> constant;  // such a number has the unit of what it is added to
  Powers powers;
};

Dimension unit_of_name(const std::string& unit) {
  const auto powers = read_unit(unit);
  return {std::nullopt, powers ? *powers : Powers{{unit, 1}}};
}

Dimension unit_of_function(const std::string& function, const Dimension& x) {
  Dimension result = x;
  if (function == "sqrt") {
    result.powers.clear();
    multiply_powers(result.powers, x.powers, 0.5);
  } else if (function.starts_with('a') && function != "abs") {  // asin, acos, atan
    result.powers = {{"rad", 1}};
  } else if (function != "-" && function != "abs") {
    result.powers.clear();
  }
  return result;
}

Dimension unit_of_sum(const Instruction& instruction, const std::string& function, const Dimension& a,
                      const Dimension& b) {
  if (a.constant) return {std::nullopt, b.powers};
  if (b.constant || in_base(a.powers) == in_base(b.powers)) return a;
  const auto shown = [](const Dimension& x) { return x.powers.empty() ? "1" : unit_text(x.powers); };
  throw FormulaError(instruction.at, fmt::format("'{}' of the units {} and {}", function, shown(a), shown(b)),
                     unit_cure);
}

Dimension unit_of_product(const Dimension& a, const Dimension& b, double exponent) {
  Dimension result = {std::nullopt, a.powers};
  multiply_powers(result.powers, b.powers, exponent);
  const bool has_others = std::any_of(result.powers.begin(), result.powers.end(),
                                      [](const auto& power) { return power.first != "rad"; });
  if (has_others && in_base(result.powers).empty()) result.powers.clear();
  return result;
}

Dimension unit_of_power(const Instruction& instruction, const Dimension& a, const Dimension& b) {
  if (!b.constant && !in_base(a.powers).empty())
    throw FormulaError(
        instruction.at,
        fmt::format("a power of the unit {} with an exponent that changes", unit_text(a.powers)), unit_cure);
  Dimension result;
  if (b.constant) multiply_powers(result.powers, a.powers, *b.constant);
  return result;
}

Dimension unit_of_both(const Instruction& instruction, const Dimension& a, const Dimension& b) {
  const FunctionOfTwo& function = functions_of_two()[instruction.index];
  if (a.constant && b.constant) return {function.value(*a.constant, *b.constant), {}};
  const std::string name = function.name;
  if (name == "*") return unit_of_product(a, b, 1);
  if (name == "/") return unit_of_product(a, b, -1);
  if (name == "^") return unit_of_power(instruction, a, b);
  return unit_of_sum(instruction, name, a, b);
}

}  // namespace

std::string unit_of(const Formula& formula, const std::vector<std::string>& units) {
  std::vector<Dimension> stack;
  for (const Instruction& instruction : formula.instructions) {
    switch (instruction.operation) {
      case Operation::constant:
        stack.push_back({instruction.constant, {}});
        break;
      case Operation::name:
        stack.push_back(unit_of_name(units[instruction.index]));
        break;
      case Operation::of_one: {
        const FunctionOfOne& function = functions_of_one()[instruction.index];
        Dimension& x = stack.back();
        x = x.constant ? Dimension{function.value(*x.constant), {}} : unit_of_function(function.name, x);
        break;
      }
      case Operation::of_two: {
        const Dimension last = std::move(stack.back());
        stack.pop_back();
        stack.back() = unit_of_both(instruction, stack.back(), last);
      }
    }
  }
  return unit_text(stack.back().powers);
}

}  // namespace scree::formula
