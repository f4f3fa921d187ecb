#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <scree/charts/ticks.hpp>

namespace scree::charts {
namespace {

// Nearer to each other than ticks can be told apart.
bool almost_equal(double lower, double upper) {
  return !(upper - lower > 1e-12 * std::max(std::abs(lower), std::abs(upper)));
}

int decade_of(double value) { return int(std::floor(std::log10(value) + 1e-9)); }

double nice_step(double raw) {
  const double power = std::pow(10.0, decade_of(raw));
  for (double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

// One exponent for the whole axis: 0.5e-5, 1.0e-5; plain decimals if they are short.
std::string label(double value, double step, double largest) {
  const int exponent = decade_of(largest);
  if (std::abs(value) < step / 2) return "0";
  if (exponent >= -2 && exponent < 5) return fmt::format("{:.{}f}", value, std::max(0, -decade_of(step)));
  return fmt::format("{:.{}f}e{}", value / std::pow(10.0, exponent), std::max(0, exponent - decade_of(step)),
                     exponent);
}

std::string logarithmic_label(double mantissa, int decade) {
  if (decade >= -2 && decade < 4) return fmt::format("{:g}", mantissa * std::pow(10.0, decade));
  return fmt::format("{:g}e{}", mantissa, decade);
}

Ticks decades(double lower, double upper, int stride, const std::vector<double>& mantissas) {
  Ticks ticks;
  const double slack = 1e-9;
  for (int decade = decade_of(lower); decade <= decade_of(upper); ++decade) {
    if (decade % stride != 0) continue;
    for (double mantissa : mantissas) {
      const double value = mantissa * std::pow(10.0, decade);
      if (value < lower * (1 - slack) || value > upper * (1 + slack)) continue;
      ticks.values.push_back(value);
      ticks.labels.push_back(logarithmic_label(mantissa, decade));
    }
  }
  return ticks;
}

std::string raised(int exponent) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : fmt::format("{}", exponent)) text += c == '-' ? "⁻" : digits[std::size_t(c - '0')];
  return text;
}

std::string with_minus(const std::string& number) {
  return number.starts_with('-') ? "−" + number.substr(1) : number;
}

}  // namespace

Ticks linear_ticks(double lower, double upper, int target, bool whole_numbers) {
  if (almost_equal(lower, upper)) return {{lower}, {fmt::format("{:.6g}", lower)}};
  double step = nice_step((upper - lower) / target);
  if (whole_numbers) step = std::max(1.0, step);
  const double largest = std::max(std::abs(lower), std::abs(upper));
  Ticks ticks;
  for (double k = std::ceil(lower / step - 1e-6); k <= upper / step + 1e-6; ++k) {
    ticks.values.push_back(k * step);
    ticks.labels.push_back(label(k * step, step, largest));
  }
  return ticks;
}

Ticks logarithmic_ticks(double lower, double upper, int target) {
  const double span = std::log10(upper / lower);
  if (span < 0.7) return linear_ticks(lower, upper, target);
  if (span < 3) return decades(lower, upper, 1, {1, 2, 5});
  return decades(lower, upper, std::max(1, int(std::ceil(span / (1.5 * target)))), {1});
}

std::string printed_number(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return with_minus(number);
  const std::string mantissa = number.substr(0, e), power = "10" + raised(std::stoi(number.substr(e + 1)));
  if (mantissa == "1" || mantissa == "-1") return with_minus(mantissa.substr(0, mantissa.size() - 1) + power);
  return with_minus(mantissa) + "·" + power;
}

AxisSpan padded(double lower, double upper, double fraction) {
  const double size = std::max(std::abs(lower), std::abs(upper));
  const double room = !almost_equal(lower, upper) ? fraction * (upper - lower) : size > 0 ? 0.1 * size : 1.0;
  return {lower - room, upper + room};
}

}  // namespace scree::charts
