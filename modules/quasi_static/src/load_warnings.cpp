#include "load_warnings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/response/quasi_static.hpp>

namespace scree::quasi_static {

// Loads that are looked at, from the start of the stage; the others are checked with their increments.
constexpr double most_loads = 10'000;

namespace {

// How the loads on the walls change from increment to increment.
struct LoadChange {
  double range = 0;  // of a load, the largest of those of all walls (N)
  // Of a load, the largest difference from a straight line within an increment, over the range of that load.
  double within = 0;
};

// Of times that are `apart`, and of one between each two that is at another share of the increment each time.
LoadChange change_of_loads(const Simulation& simulation, double start, double end, double apart) {
  constexpr double golden_share = 0.6180339887498949;
  const auto count = std::size_t(std::min(most_loads, std::ceil((end - start) / apart)));
  const auto loads_at = [&](double time) {
    return response::loads_of_walls(simulation, std::min(time, end));
  };
  std::vector<double> before = loads_at(start), least = before, most = before;
  std::vector<double> within(before.size());
  const auto extend = [&](std::size_t w, double load) {
    least[w] = std::min(least[w], load);
    most[w] = std::max(most[w], load);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const double from = start + double(k) * apart, to = std::min(from + apart, end);
    const double share = std::fmod(double(k + 1) * golden_share, 1);
    const std::vector<double> between = loads_at(std::lerp(from, to, share));
    std::vector<double> after = loads_at(to);
    for (std::size_t w = 0; w < after.size(); ++w) {
      extend(w, between[w]);
      extend(w, after[w]);
      within[w] = std::max(within[w], std::abs(between[w] - std::lerp(before[w], after[w], share)));
    }
    before = std::move(after);
  }
  LoadChange change;
  for (std::size_t w = 0; w < within.size(); ++w) {
    const double range = most[w] - least[w];
    change.range = std::max(change.range, range);
    if (range > 0) change.within = std::max(change.within, within[w] / range);
  }
  return change;
}

}  // namespace

std::vector<std::string> load_warnings(const Simulation& simulation, const Course& course,
                                       unsigned increments) {
  constexpr double much = 0.05;  // a sine that eight straight lines replace is wrong by 0.04
  // Those of whole periods are all alike.
  const double apart = course.period > 0
                           ? std::min(course.increment, course.period / FollowOptions::fewest_per_cycle)
                           : course.increment;
  const LoadChange change = change_of_loads(simulation, course.start, course.end, apart);
  std::vector<std::string> warnings;
  if (!(change.range > 0))
    warnings.push_back(
        "no load on a wall changes in the last stage; give a stress or force that changes with time");
  if (change.within > much)
    warnings.push_back(fmt::format(
        "a load changes within an increment of {:.4g} s by {:.2g} of its range, which is left out; give more "
        "--increments",
        apart, change.within));
  if (course.period > 0 && increments < FollowOptions::fewest_per_cycle)
    warnings.push_back(fmt::format("--increments {} leaves most loads of a period out; give at least {}",
                                   increments, FollowOptions::fewest_per_cycle));
  for (const std::string& law : response::laws_that_integrate_spins(simulation))
    warnings.push_back(fmt::format(
        "contact law '{}' integrates spins with the geometry at the end of each increment, which leaves a strain per cycle in proportion to the increment; "
        "compare several --increments, or take a law with painted points, such as disc_angular",
        law));
  return warnings;
}

std::string dynamics_warning(const Course& course) {
  constexpr double much = 0.05;
  const double share = course.dynamic_time() / (course.reached - course.start);
  if (!(share > much)) return "";
  return fmt::format(
      "{:.2g} % of the load were followed by dynamics, and the load went on while the packing moved; give the load more time, or compare "
      "two times",
      100 * share);
}

}  // namespace scree::quasi_static
