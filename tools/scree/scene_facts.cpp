#include "scene_facts.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

std::string point(const Vec3& p, int dimension) {
  return dimension == 2 ? fmt::format("({:.4g}, {:.4g})", p[0], p[1])
                        : fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0], p[1], p[2]);
}

// 1.2e5 s is "about 1.4 days".
std::string about(double seconds) {
  constexpr std::pair<double, const char*> units[] = {
      {365.25 * 86400, "years"}, {86400, "days"}, {3600, "hours"}, {60, "minutes"}};
  for (const auto& [unit, name] : units)
    if (seconds >= 1.5 * unit) return fmt::format("about {:.2g} {}", seconds / unit, name);
  return seconds < 1 ? "less than a second" : fmt::format("about {:.2g} s", seconds);
}

// All stages, as long as they may become (s).
double longest_time(const scenario::Plan& plan) {
  double sum = 0;
  for (const Stage& stage : plan.stages)
    sum += stage.duration ? *stage.duration : stage.until.at_most.value_or(0);
  return sum;
}

// Of a body as a sphere, or as a disc of unit thickness (kg/m³).
double density_of(const Body& b, int dimension) {
  const double area = std::numbers::pi * b.radius * b.radius;
  return b.mass / (dimension == 2 ? area : area * b.radius * 4 / 3);
}

}  // namespace

std::string extent_of_bodies(const Simulation& s) {
  Vec3 low = {{INFINITY, INFINITY, INFINITY}}, high = -low;
  double smallest = INFINITY, largest = 0;
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    for (int k = 0; k < s.dimension(); ++k)
      low[k] = std::min(low[k], b.position[k] - b.radius),
      high[k] = std::max(high[k], b.position[k] + b.radius);
    smallest = std::min(smallest, b.radius), largest = std::max(largest, b.radius);
  }
  const std::string radii = smallest == largest ? fmt::format("radius {:.4g} m", largest)
                                                : fmt::format("radii {:.4g} to {:.4g} m", smallest, largest);
  return fmt::format("bodies from {} to {} m, {}", point(low, s.dimension()), point(high, s.dimension()),
                     radii);
}

std::string expected_wall_time(const scenario::Plan& plan, Simulation& simulation) {
  using Clock = std::chrono::steady_clock;
  const double steps = longest_time(plan) / simulation.step_length();
  const auto elapsed = [start = Clock::now()] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  if (!(steps >= 1)) return "";
  std::uint64_t taken = 0;
  try {
    // The first step searches neighbours.
    while ((taken < 2 || elapsed() < 0.3) && double(taken) < steps)
      taken += simulation.run(1, [] { return true; });
  } catch (const Error&) {
    return "";
  }
  const double rate = double(taken) / elapsed();  // steps/s
  const double work = rate * double(simulation.particles().size());
  const bool bounded =
      std::any_of(plan.stages.begin(), plan.stages.end(), [](const Stage& s) { return !s.duration; });
  return fmt::format(
      "{}{} of wall time without pictures, at {:.2g} M particle-steps/s, the speed of the first steps on one core",
      bounded ? "at most " : "", about(steps / rate), work / 1e6);
}

std::vector<std::string> unusual_numbers(const scenario::Plan& plan) {
  constexpr double gas = 20, osmium = 23e3;       // (kg/m³)
  constexpr double boulder = 1, smallest = 1e-8;  // (m)
  std::vector<std::string> lines;
  const auto add = [&](const Body& b, const std::string& what, const char* cure) {
    lines.push_back(fmt::format("particle {} has {}; {}", b.id, what, cure));
  };
  const auto& bodies = plan.scene.bodies;
  const auto first = [&](auto is_unusual) { return std::find_if(bodies.begin(), bodies.end(), is_unusual); };
  const int dimension = plan.scene.dimension;
  if (const auto b = first([&](const Body& x) { return density_of(x, dimension) < gas; }); b != bodies.end())
    add(*b, fmt::format("a density of {:.3g} kg/m^3", density_of(*b, dimension)),
        "glass has 2500 kg/m^3; give densities in kg/m^3, not in g/cm^3");
  if (const auto b = first([&](const Body& x) { return density_of(x, dimension) > osmium; });
      b != bodies.end())
    add(*b, fmt::format("a density of {:.3g} kg/m^3", density_of(*b, dimension)), "no solid has as much");
  if (const auto b = first([](const Body& x) { return x.radius > boulder; }); b != bodies.end())
    add(*b, fmt::format("a radius of {:.3g} m", b->radius),
        "give lengths in m, not in mm or in units of a diameter");
  if (const auto b = first([](const Body& x) { return x.radius < smallest; }); b != bodies.end())
    add(*b, fmt::format("a radius of {:.3g} m", b->radius), "laws of contact hold for larger grains");
  return lines;
}

}  // namespace scree::tool
