#pragma once

#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include <scree/formula/formula.hpp>

namespace scree::test {

inline constexpr double a = 1.7, b = -0.6, c = 2.3;

// The value of a formula of p.a, p.b, p.c and time.
inline double computed(const std::string& text) {
  const formula::Formula formula = formula::parse(text);
  std::vector<double> values;
  for (const formula::Name& name : formula.names)
    values.push_back(name.text == "p.a" ? a : name.text == "p.b" ? b : name.text == "p.c" ? c : 0.25);
  return formula::value(formula, values);
}

// "<bytes before>: <what is wrong>; <cure>"
template <class Read>
std::string refusal_of(const Read& read) {
  try {
    read();
  } catch (const formula::FormulaError& error) {
    return std::to_string(error.at) + ": " + error.what();
  }
  return "no error";
}

}  // namespace scree::test
