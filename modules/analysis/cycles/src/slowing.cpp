#include "slowing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace scree::cycles {

namespace {

using Law = Slowing::Law;

// Longer series are averaged in at most so many blocks.
constexpr std::size_t most_points = 300;
// Ranges of scales (the shortest in cycles, the longest over the number of cycles) and of exponents. A power
// with an exponent nearer to 0 is a logarithm.
constexpr double shortest_scale = 0.3, longest_scale = 100, least_exponent = 0.03, most_exponent = 0.95,
                 steepest = 6;
// Largest correlation of neighbours; above it noise is not told from a curve that the law misses.
constexpr double most_memory = 0.9;
// Share of the square of a column that must be orthogonal to the columns before it.
constexpr double least_left = 1e-24;

// The points of a series, and of functions, prewhitened: each less a share of the point before.
class Points {
 public:
  explicit Points(std::span<const double> values)
      : block_((values.size() + most_points - 1) / most_points), values_(values.size() / block_) {
    // Relative to the first value, so that small changes of large values keep their digits.
    for (std::size_t j = 0; j < values_.size(); ++j)
      for (std::size_t k = 0; k < block_; ++k)
        values_[j] += (values[j * block_ + k] - values[0]) / double(block_);
  }
  std::size_t size() const { return values_.size(); }
  double cycles() const { return double(values_.size() * block_); }
  void set_memory(double memory) { memory_ = memory; }
  std::vector<double> values() const { return fresh(values_); }
  template <class Function>
  std::vector<double> column(const Function& function) const {
    std::vector<double> all(size());
    for (std::size_t j = 0; j < all.size(); ++j)
      all[j] = function(double(j * block_) + 0.5 * double(block_ - 1));
    return fresh(std::move(all));
  }

 private:
  std::vector<double> fresh(std::vector<double> all) const {
    for (std::size_t j = all.size(); j-- > 1;) all[j] -= memory_ * all[j - 1];
    // The first has no point before it, and the variance of all.
    all[0] *= std::sqrt(1 - memory_ * memory_);
    return all;
  }

  std::size_t block_;
  std::vector<double> values_;
  double memory_ = 0;
};

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

void subtract(std::vector<double>& from, double share, const std::vector<double>& column) {
  for (std::size_t j = 0; j < from.size(); ++j) from[j] -= share * column[j];
}

struct LeastSquares {
  std::vector<double> rest;  // values less the fit
  double squares = 0;        // of these
  std::array<double, 3> coefficients = {};
};

// Least squares by orthogonalisation of at most three columns.
LeastSquares least_squares(std::vector<double> values, std::vector<std::vector<double>> columns) {
  std::array<std::array<double, 3>, 3> along = {};  // [d][c]: share of the unit column d in column c
  LeastSquares result;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double whole = product(columns[c], columns[c]);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t d = 0; d < c; ++d) {
        const double share = product(columns[c], columns[d]);
        along[d][c] += share;
        subtract(columns[c], share, columns[d]);
      }
    const double square = product(columns[c], columns[c]);
    along[c][c] = square > least_left * whole ? std::sqrt(square) : std::numeric_limits<double>::infinity();
    for (double& x : columns[c]) x /= along[c][c];
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    result.coefficients[c] = product(values, columns[c]);
    subtract(values, result.coefficients[c], columns[c]);
  }
  for (std::size_t c = columns.size(); c-- > 0;) {
    for (std::size_t d = c + 1; d < columns.size(); ++d)
      result.coefficients[c] -= along[c][d] * result.coefficients[d];
    result.coefficients[c] /= along[c][c];
  }
  result.squares = product(values, values);
  result.rest = std::move(values);
  return result;
}

bool has_line(Law law) { return law == Law::exponential_and_line || law == Law::power_and_line; }
bool has_exponent(Law law) {
  return law == Law::power || law == Law::power_to_limit || law == Law::power_and_line;
}

// The settling part of a law for amplitude 1.
double settling(const Slowing& s, double k) {
  if (s.law == Law::logarithm) return std::log1p(k / s.scale);
  if (!has_exponent(s.law)) return std::exp(-k / s.scale);
  return std::exp(s.exponent * std::log1p(k / s.scale));
}

LeastSquares fit(const Points& points, const Slowing& s) {
  std::vector<std::vector<double>> columns = {points.column([](double) { return 1.0; }),
                                              points.column([&](double k) { return settling(s, k); })};
  if (has_line(s.law)) columns.push_back(points.column([](double k) { return k; }));
  return least_squares(points.values(), std::move(columns));
}

// A point with the value of a function.
struct Corner {
  double x, y, value;
};

// The minimum by the method of Nelder and Mead, from a triangle.
template <class Function>
Corner least_about(std::array<Corner, 3> corners, const Function& function) {
  constexpr int most_steps = 70;
  const auto at = [&](const Corner& from, const Corner& to, double share) {
    return function(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
  };
  for (int step = 0; step < most_steps; ++step) {
    std::sort(corners.begin(), corners.end(),
              [](const Corner& a, const Corner& b) { return a.value < b.value; });
    const Corner middle{0.5 * (corners[0].x + corners[1].x), 0.5 * (corners[0].y + corners[1].y), 0};
    const Corner across = at(corners[2], middle, 2);
    if (across.value < corners[0].value) {
      const Corner further = at(corners[2], middle, 3);
      corners[2] = further.value < across.value ? further : across;
    } else if (across.value < corners[1].value) {
      corners[2] = across;
    } else if (const Corner nearer = at(corners[2], middle, across.value < corners[2].value ? 1.5 : 0.5);
               nearer.value < std::min(across.value, corners[2].value)) {
      corners[2] = nearer;
    } else {
      for (std::size_t c : {1, 2}) corners[c] = at(corners[c], corners[0], 0.5);
    }
  }
  return *std::min_element(corners.begin(), corners.end(),
                           [](const Corner& a, const Corner& b) { return a.value < b.value; });
}

// Akaike's criterion, corrected for few values. The variance of the residual is a parameter.
double criterion_of(Law law, double squares, double values) {
  const double p = 4 + int(has_exponent(law)) + int(has_line(law));
  constexpr double least = 1e-300;
  return values * std::log(std::max(squares, least) / values) + 2 * p + 2 * p * (p + 1) / (values - p - 1);
}

struct Fitted {
  Slowing slowing;
  LeastSquares squares;
};

Fitted fitted(const Points& points, Law law) {
  Slowing s;
  s.law = law;
  const double low = std::log(shortest_scale), high = std::log(longest_scale * points.cycles());
  // Exponents by their logarithms: a factor changes an exponent near 0 as much as one of 6.
  const double sign = law == Law::power ? 1 : -1;
  const double least = std::log(least_exponent),
               most = std::log(law == Law::power ? most_exponent : steepest);
  const auto squares = [&](double scale, double exponent) {
    scale = std::clamp(scale, low, high), exponent = std::clamp(exponent, least, most);
    s.scale = std::exp(scale), s.exponent = has_exponent(law) ? sign * std::exp(exponent) : 0;
    return Corner{scale, exponent, fit(points, s).squares};
  };
  const int scales = 10, exponents = has_exponent(law) ? 6 : 1;
  const double step = (high - low) / (scales - 1), turn = (most - least) / 5;
  Corner best{0, 0, std::numeric_limits<double>::infinity()};
  for (int e = 0; e < exponents; ++e)
    for (int k = 0; k < scales; ++k)
      if (const Corner corner = squares(low + k * step, least + e * turn); corner.value < best.value)
        best = corner;
  const double inwards = best.x > 0.5 * (low + high) ? -0.5 : 0.5,
               over = best.y > 0.5 * (least + most) ? -0.5 : 0.5;
  best = least_about({best, squares(best.x + inwards * step, best.y), squares(best.x, best.y + over * turn)},
                     squares);
  squares(best.x, best.y);
  Fitted result{s, fit(points, s)};
  result.slowing.amplitude = result.squares.coefficients[1];
  result.slowing.slope = result.squares.coefficients[2];
  result.slowing.constant = result.squares.coefficients[0];
  result.slowing.criterion = criterion_of(law, result.squares.squares, double(points.size()));
  return result;
}

double memory_of_rest(const std::vector<double>& rest) {
  double products = 0, squares = 0;
  for (std::size_t j = 0; j < rest.size(); ++j) {
    squares += rest[j] * rest[j];
    if (j > 0) products += rest[j] * rest[j - 1];
  }
  return squares > 0 ? std::clamp(products / squares, 0.0, most_memory) : 0;
}

Slowing better(const Slowing& a, const Slowing& b) { return b.criterion < a.criterion ? b : a; }

// Whether lines through the two halves of the values agree to a tenth of the slope, which a rest of the
// settling part may have, or to two errors.
bool keeps_its_slope(std::span<const double> values) {
  constexpr double same_slope = 0.1, errors = 2;
  const StraightLine first = fit_line(values.first(values.size() / 2)),
                     last = fit_line(values.subspan(values.size() / 2));
  const double allowed = std::max(same_slope * std::abs(first.slope + last.slope) / 2,
                                  errors * std::hypot(first.slope_error, last.slope_error));
  return std::abs(first.slope - last.slope) <= allowed;
}

// The first value from which the settling part adds less than the strain of a cycle.
std::size_t end_of_settling(const Slowing& s, std::size_t values) {
  std::size_t k = 0;
  while (k < values && !(std::abs(s.amplitude * settling(s, double(k))) < std::abs(s.slope))) ++k;
  return k;
}

bool is_straight(std::span<const double> values, std::size_t from, const Slowing& s, double round_off) {
  constexpr std::size_t least_settling = 3;  // values; fewer are outliers
  constexpr double least_slope = 5;          // errors
  if (from < least_settling || values.size() - from < std::max(least_for_law, values.size() / 3))
    return false;
  const std::span<const double> rest = values.subspan(from);
  const StraightLine line = fit_line(rest);
  return std::abs(line.slope) > std::max(round_off, least_slope * line.slope_error) &&
         line.slope * s.slope > 0 && keeps_its_slope(rest);
}

}  // namespace

SlowingDown slowing_down(std::span<const double> values, double round_off, double preference) {
  Points points(values);
  // The laws with most parameters leave only the noise.
  const Fitted falls = fitted(points, Law::power_and_line), rises = fitted(points, Law::power);
  points.set_memory(
      memory_of_rest((falls.squares.squares < rises.squares.squares ? falls : rises).squares.rest));
  const auto best_of = [&](Law a, Law b) {
    Slowing best = better(fitted(points, a).slowing, fitted(points, b).slowing);
    best.constant += values[0];
    return best;
  };
  SlowingDown all{best_of(Law::exponential, Law::power_to_limit), best_of(Law::logarithm, Law::power),
                  best_of(Law::exponential_and_line, Law::power_and_line)};
  all.preference = all.without_limit.criterion - all.with_limit.criterion;
  all.straight_from = end_of_settling(all.with_line, values.size());
  all.straight = all.with_line.criterion + preference < better(all.with_limit, all.without_limit).criterion &&
                 is_straight(values, all.straight_from, all.with_line, round_off);
  return all;
}

double value_of(const Slowing& s, double k) {
  return s.constant + s.amplitude * settling(s, k) + s.slope * k;
}

std::string law_text(const Slowing& s) {
  std::string text = s.law == Law::logarithm ? fmt::format("{:.3e} log(1 + k/{:.3g})", s.amplitude, s.scale)
                     : has_exponent(s.law)
                         ? fmt::format("{:.3e} (1 + k/{:.3g})^{:.3g}", s.amplitude, s.scale, s.exponent)
                         : fmt::format("{:.3e} exp(-k/{:.3g})", s.amplitude, s.scale);
  if (s.law == Law::exponential || s.law == Law::power_to_limit)
    text = fmt::format("{:.6g} + {}", s.constant, text);
  return has_line(s.law) ? fmt::format("{} + {:.3e} k", text, s.slope) : text;
}

}  // namespace scree::cycles
