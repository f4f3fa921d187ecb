#include <cmath>

#include <scree/formula/formula.hpp>

namespace scree::formula {

namespace {

// Without a value if one of them has none.
double smaller(double a, double b) { return a < b || std::isnan(a) ? a : b; }
double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }

constexpr FunctionOfOne one_argument[] = {{"-", [](double x) { return -x; }},
                                          {"sqrt", [](double x) { return std::sqrt(x); }},
                                          {"abs", [](double x) { return std::abs(x); }},
                                          {"exp", [](double x) { return std::exp(x); }},
                                          {"log", [](double x) { return std::log(x); }},
                                          {"log10", [](double x) { return std::log10(x); }},
                                          {"sin", [](double x) { return std::sin(x); }},
                                          {"cos", [](double x) { return std::cos(x); }},
                                          {"tan", [](double x) { return std::tan(x); }},
                                          {"asin", [](double x) { return std::asin(x); }},
                                          {"acos", [](double x) { return std::acos(x); }},
                                          {"atan", [](double x) { return std::atan(x); }}};

constexpr FunctionOfTwo two_arguments[] = {{"+", [](double a, double b) { return a + b; }},
                                           {"-", [](double a, double b) { return a - b; }},
                                           {"*", [](double a, double b) { return a * b; }},
                                           {"/", [](double a, double b) { return a / b; }},
                                           {"^", [](double a, double b) { return std::pow(a, b); }},
                                           {"min", smaller},
                                           {"max", larger}};

}  // namespace

std::span<const FunctionOfOne> functions_of_one() { return one_argument; }
std::span<const FunctionOfTwo> functions_of_two() { return two_arguments; }

}  // namespace scree::formula
