#include "load_warnings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/response/quasi_static.hpp>

namespace scree::quasi_static {

// Loads that are looked at, from the start of the stage; the others are checked with their increments.
constexpr double most_loads = 10'000;

std::vector<std::string> load_warnings(const Simulation& simulation, const Course& course,
                                       unsigned increments) {
  const double length = course.end - course.start;
  // Those of whole periods are all alike.
  const double apart = course.period > 0
                           ? std::min(course.increment, course.period / FollowOptions::fewest_per_cycle)
                           : course.increment;
  const auto times = std::size_t(std::min(most_loads, std::ceil(length / apart)));
  const auto loads_at = [&](std::size_t k) {
    return response::loads_of_walls(simulation, std::min(course.start + double(k) * apart, course.end));
  };
  bool changes = false;
  const std::vector<double> first = loads_at(0);
  for (std::size_t k = 1; k <= times; ++k) changes = loads_at(k) != first || changes;
  std::vector<std::string> warnings;
  if (!changes)
    warnings.push_back(
        "no load on a wall changes in the last stage; give a stress or force that changes with time");
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

}  // namespace scree::quasi_static
