#include "numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/charts/ticks.hpp>

namespace scree::report {

double parsed(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failed] = std::from_chars(text.data(), end, value);
  return failed == std::errc() && rest == end ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string number_text(double number, int digits) {
  if (std::isnan(number)) return no_number;
  if (std::isinf(number)) return number < 0 ? "−∞" : "∞";
  return charts::printed_number(fmt::format("{:.{}g}", number, digits));
}

std::string count_text(double count) {
  constexpr double most = 1e15;
  if (!(std::abs(count) < most)) return number_text(count);
  std::string digits = fmt::format("{:.0f}", std::abs(count)), text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    // A narrow blank at which no line ends.
    if (k > 0 && (digits.size() - k) % 3 == 0 && digits.size() > 4) text += "\u202F";
    text += digits[k];
  }
  return (count < 0 ? "−" : "") + text;
}

std::string with_unit(double number, const std::string& unit, int digits) {
  if (std::isnan(number)) return no_number;
  const charts::ScaledUnit scaled = charts::scaled_unit(std::abs(number), unit);
  return number_text(number * scaled.factor, digits) + "\u00A0" + scaled.symbol;
}

std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (!(seconds >= 100)) return with_unit(seconds, "s", 3);
  if (seconds < hour)
    return fmt::format("{:.0f} min {:.0f} s", std::floor(seconds / minute), std::fmod(seconds, minute));
  return fmt::format("{} h {:.0f} min", count_text(std::floor(seconds / hour)),
                     std::floor(std::fmod(seconds, hour) / minute));
}

std::string with_error(double value, double error) {
  if (!std::isfinite(value) || !std::isfinite(error) || error <= 0) return number_text(value, 4);
  const double larger = std::max(std::abs(value), error);
  const int power = int(std::floor(std::log10(larger)));
  const bool scaled = power < -2 || power > 3;
  const double scale = scaled ? std::pow(10.0, power) : 1;
  const int decimals = std::clamp(1 - int(std::floor(std::log10(error / scale))), 0, 12);
  std::string text = fmt::format("{:.{}f} ± {:.{}f}", value / scale, decimals, error / scale, decimals);
  if (text.starts_with('-')) text = "−" + text.substr(1);
  return scaled ? fmt::format("({})·{}", text, charts::printed_number(fmt::format("1e{}", power))) : text;
}

}  // namespace scree::report
