#include "sweep_points.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <catch2/catch.hpp>

using namespace scree::spectrum;

namespace {

using Frequencies = std::vector<double>;

SpectrumPlan plan_of_grid(SweepSettings::Direction direction, bool adaptive) {
  SpectrumPlan plan;
  plan.from_hz = 100, plan.to_hz = 118, plan.step_hz = 1;
  plan.observed.resize(1);
  plan.sweep.direction = direction;
  plan.sweep.adaptive = adaptive;
  return plan;
}

// Points of 1/(f² − f0² + i f b).
std::vector<SweepPoint> points_at(const Frequencies& frequencies, double f0, double b) {
  std::vector<SweepPoint> points;
  for (const double f : frequencies) {
    SweepPoint point;
    point.frequency = f;
    point.columns = {{1.0 / std::complex<double>(f * f - f0 * f0, f * b), 0, 0}};
    points.push_back(point);
  }
  return points;
}

}  // namespace

TEST_CASE("a sweep begins with all frequencies, or with every eighth and the last, in its order",
          "[spectrum]") {
  using Direction = SweepSettings::Direction;
  CHECK(first_frequencies(plan_of_grid(Direction::up, false)).size() == 19);
  CHECK(first_frequencies(plan_of_grid(Direction::up, true)) == Frequencies{100, 108, 116, 118});
  CHECK(first_frequencies(plan_of_grid(Direction::down, true)) == Frequencies{118, 116, 108, 100});
  CHECK(first_frequencies(plan_of_grid(Direction::both, true)) ==
        Frequencies{100, 108, 116, 118, 118, 116, 108, 100});
}

TEST_CASE("an adaptive sweep halves intervals where phase or amplitude vary, down to the grid",
          "[spectrum]") {
  const SpectrumPlan plan = plan_of_grid(SweepSettings::Direction::up, true);
  Frequencies known = first_frequencies(plan);
  for (int k = 0; k < 10; ++k) {
    const Frequencies further = further_frequencies(plan, points_at(known, 105, 2));
    if (k == 0) CHECK(further == Frequencies{104, 112});  // beside the maximum, at 108
    for (const double f : further) {
      CHECK(std::find(known.begin(), known.end(), f) == known.end());
      CHECK(f == std::round(f));
      known.push_back(f);
    }
  }
  // All of the grid about the resonance.
  for (double f = 102; f <= 108; ++f) CHECK(std::find(known.begin(), known.end(), f) != known.end());
  CHECK(further_frequencies(plan, points_at(known, 105, 2)).empty());
  CHECK(further_frequencies(plan_of_grid(SweepSettings::Direction::up, false), points_at({100, 118}, 105, 2))
            .empty());
}
