#pragma once

#include <string>
#include <string_view>

// Numbers as a page prints them.
namespace scree::report {

// The number that a cell of a table is; NaN if it is none.
double parsed(std::string_view text);

inline constexpr const char* no_number = "–";

// A number in at most `digits` digits, 1.2·10⁻⁵; a dash if it is NaN.
std::string number_text(double number, int digits = 4);
// A whole number in groups of three digits.
std::string count_text(double count);
// A number with a prefix before its unit: 5.79 µs.
std::string with_unit(double number, const std::string& unit, int digits = 4);
// A duration that someone waited for: 5.3 s, 2 min 5 s, 3 h 12 min.
std::string duration_text(double seconds);
// A value with its standard error in two digits, both with one power of ten: (9.65 ± 0.12)·10⁻⁴; the value
// alone if there is no error.
std::string with_error(double value, double error);

}  // namespace scree::report
