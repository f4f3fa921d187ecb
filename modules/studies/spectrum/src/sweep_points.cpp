#include "sweep_points.hpp"

#include <algorithm>
#include <cmath>

namespace scree::spectrum {

namespace {

constexpr std::size_t coarse = 8;  // steps of the grid
constexpr double largest_turn = 0.4, largest_growth = 0.3;

std::vector<double> ordered(const SpectrumPlan& plan, std::vector<double> up) {
  std::vector<double> down(up.rbegin(), up.rend());
  if (plan.sweep.direction == SweepSettings::Direction::up) return up;
  if (plan.sweep.direction == SweepSettings::Direction::both) down.insert(down.begin(), up.begin(), up.end());
  return down;
}

std::size_t number_of(const SpectrumPlan& plan, double frequency) {
  return std::size_t(std::round((frequency - plan.from_hz) / plan.step_hz));
}

double size_at(const std::vector<SweepPoint>& points, std::size_t k, std::size_t column) {
  return std::abs(points[k].columns[column].response);
}

bool is_maximum(const std::vector<SweepPoint>& points, std::size_t k, std::size_t column) {
  const double here = size_at(points, k, column);
  return (k == 0 || here >= size_at(points, k - 1, column)) &&
         (k + 1 == points.size() || here >= size_at(points, k + 1, column));
}

// Whether one of the first `columns` does so between the points k and k + 1.
bool varies(const std::vector<SweepPoint>& points, std::size_t k, std::size_t columns) {
  for (std::size_t c = 0; c < columns; ++c) {
    const std::complex<double> ratio = points[k + 1].columns[c].response / points[k].columns[c].response;
    if (!(std::abs(std::arg(ratio)) <= largest_turn && std::abs(std::log(std::abs(ratio))) <= largest_growth))
      return true;
    if (is_maximum(points, k, c) || is_maximum(points, k + 1, c)) return true;
  }
  return false;
}

}  // namespace

void SweepPoint::transfer(const StateTransfer& state, std::size_t observed) {
  state.value("frequency", "1/s", frequency, stored::positive);
  state.value("start", "s", start);
  state.value("steps", "1", steps);
  state.value("drive", "m", drive, stored::any);
  state.value("periods", "1", periods, stored::non_negative);
  state.value("is_steady", "", is_steady);
  std::vector<double> numbers;
  if (state.restoring()) numbers.resize(4 * observed);
  for (const Column& c : columns)
    numbers.insert(numbers.end(), {c.response.real(), c.response.imag(), c.error, c.mean});
  state.sized_rows("columns", "1", numbers, 1, stored::any);
  columns.resize(numbers.size() / 4);
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = {{numbers[4 * c], numbers[4 * c + 1]}, numbers[4 * c + 2], numbers[4 * c + 3]};
}

std::vector<double> first_frequencies(const SpectrumPlan& plan) {
  const std::vector<double> all = plan.frequencies();
  if (!plan.sweep.adaptive) return ordered(plan, all);
  std::vector<double> some;
  for (std::size_t k = 0; k < all.size(); k += coarse) some.push_back(all[k]);
  if (some.back() != all.back()) some.push_back(all.back());
  return ordered(plan, some);
}

std::vector<double> further_frequencies(const SpectrumPlan& plan, std::vector<SweepPoint> points) {
  if (!plan.sweep.adaptive) return {};
  const std::vector<double> all = plan.frequencies();
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  std::vector<double> further;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const std::size_t low = number_of(plan, points[k].frequency),
                      high = number_of(plan, points[k + 1].frequency);
    if (high - low > 1 && varies(points, k, responding(plan.observed)))
      further.push_back(all[(low + high) / 2]);
  }
  return ordered(plan, further);
}

}  // namespace scree::spectrum
