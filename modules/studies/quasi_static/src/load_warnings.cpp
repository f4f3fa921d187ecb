#include "load_warnings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/response/quasi_static.hpp>

namespace scree::quasi_static {

namespace {

// Increments that are looked at; of more these many, evenly over the stage and without a period.
constexpr double most_loads = 10'000;

// How the loads on the walls change from increment to increment.
struct LoadChange {
  double range = 0;   // of a load, the largest of those of all walls (N)
  double within = 0;  // largest difference of a load from a straight line within an increment (N)
};

// At the ends of increments and at a time within each, at another share of the increment each time.
LoadChange change_of_loads(const Simulation& simulation, double start, double end, double increment) {
  constexpr double golden_share = 0.6180339887498949;
  const double increments = std::ceil((end - start) / increment);
  const auto loads_at = [&](double time) {
    return response::loads_of_walls(simulation, std::min(time, end));
  };
  std::vector<double> least = loads_at(start), most = least;
  LoadChange change;
  for (double n = 0; n < std::min(increments, most_loads); ++n) {
    const double share = std::fmod((n + 1) * golden_share, 1);
    const double k = increments > most_loads ? std::floor(share * increments) : n;
    const double from = start + k * increment, to = std::min(from + increment, end);
    const std::vector<double> before = loads_at(from), between = loads_at(std::lerp(from, to, share)),
                              after = loads_at(to);
    for (std::size_t w = 0; w < after.size(); ++w) {
      const auto [low, high] = std::minmax({before[w], between[w], after[w]});
      least[w] = std::min(least[w], low);
      most[w] = std::max(most[w], high);
      change.within = std::max(change.within, std::abs(between[w] - std::lerp(before[w], after[w], share)));
    }
  }
  for (std::size_t w = 0; w < least.size(); ++w) change.range = std::max(change.range, most[w] - least[w]);
  return change;
}

}  // namespace

std::vector<std::string> load_warnings(const Simulation& simulation, const FollowedLoad& load,
                                       unsigned increments) {
  constexpr double much = 0.05;  // a sine that eight straight lines replace is wrong by 0.04
  const bool few = load.period > 0 && increments < FollowOptions::fewest_per_cycle;
  const double increment = few ? load.period / FollowOptions::fewest_per_cycle : load.increment;
  const LoadChange change = change_of_loads(simulation, load.start, load.end, increment);
  std::vector<std::string> warnings;
  if (!(change.range > 0))
    warnings.push_back(
        "no load on a wall changes in the last stage; give a stress or force that changes with time");
  if (few)
    warnings.push_back(fmt::format("--increments {} leaves most loads of a period out; give at least {}",
                                   increments, FollowOptions::fewest_per_cycle));
  else if (change.within > much * change.range)
    warnings.push_back(fmt::format(
        "a load changes within an increment of {:.4g} s by {:.2g} of the range of the loads, which is left out; give more --increments",
        increment, change.within / change.range));
  for (const std::string& law : response::laws_that_integrate_spins(simulation))
    warnings.push_back(fmt::format(
        "contact law '{}' integrates spins with the geometry at the end of each increment, which leaves a strain per cycle in proportion to the increment; "
        "compare several --increments, or take a law with painted points, such as disc_angular",
        law));
  return warnings;
}

std::string dynamics_warning(const FollowedLoad& load) {
  constexpr double much = 0.05, most = 0.5;
  const double share = load.dynamic_time() / (load.reached - load.start);
  if (!(share > much)) return "";
  const char* cure =
      share > most
          ? "the packing has no equilibrium nearby for long; run it with scree run, or compress it further"
          : "the load went on while the packing moved; give the load more time, or compare two times";
  return fmt::format("dynamics followed the load for {:.0f} % of the time: {}", 100 * share, cure);
}

}  // namespace scree::quasi_static
