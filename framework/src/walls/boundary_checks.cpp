#include "walls/boundary_checks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>

namespace scree {

namespace {

// More would be a wrong number rather than a scene: every plane is tested against every body.
constexpr std::uint32_t most_planes = 100000, most_state = 10000000;

[[noreturn]] void refuse(const std::string& plugin, const std::string& problem) {
  throw Error(fmt::format("boundary plug-in {}: {}; correct the plug-in", plugin, problem));
}

}  // namespace

void check_layout(const std::string& plugin, const scree_boundary_instance& i, int dimension) {
  if (i.plane_count > most_planes || i.state_width > most_state)
    refuse(plugin,
           fmt::format("it has {} and {} of state, of at most {} and {}", counted(i.plane_count, "wall"),
                       counted(i.state_width, "number"), most_planes, most_state));
  for (std::uint32_t w = 0; i.plane_names && w < i.plane_count; ++w)
    if (!i.plane_names[w]) refuse(plugin, fmt::format("the name of wall {} is NULL", w + 1));
  for (std::uint32_t w = 0; i.plane_masses && w < i.plane_count; ++w)
    if (!(i.plane_masses[w] >= 0 && std::isfinite(i.plane_masses[w])))
      refuse(plugin, fmt::format("the mass of wall {} is {:g} kg", w + 1, i.plane_masses[w]));
  if (!(i.surface_mass >= 0 && std::isfinite(i.surface_mass)))
    refuse(plugin, fmt::format("the mass of its surfaces is {:g} kg", i.surface_mass));
  if (!(i.damping_rate >= 0)) refuse(plugin, fmt::format("its damping rate is {:g}/s", i.damping_rate));
  if (!(i.displacement_speed >= 0 && std::isfinite(i.displacement_speed)))
    refuse(plugin, fmt::format("its displacement_speed is {:g} m/s", i.displacement_speed));
  for (int k = 0; k < dimension; ++k)
    if (i.periodic[k] && !(std::isfinite(i.upper[k] - i.lower[k]) && i.upper[k] > i.lower[k]))
      refuse(plugin, fmt::format("the periodic axis {} reaches from {:g} to {:g} m", "xyz"[k], i.lower[k],
                                 i.upper[k]));
}

bool is_finite(const scree_plane& plane) {
  // On the bits, so that the compiler may take the largest in any order.
  constexpr std::uint64_t magnitude = ~(std::uint64_t(1) << 63), infinite_bits = std::uint64_t(0x7ff) << 52;
  std::uint64_t largest = 0;
  for (int k = 0; k < 3; ++k)
    for (const double x : {plane.point[k], plane.normal[k], plane.velocity[k], plane.mid_velocity[k]})
      largest = std::max(largest, std::bit_cast<std::uint64_t>(x) & magnitude);
  return largest < infinite_bits;
}

std::string problem_of(const scree_plane& plane) {
  const auto bad = [](const char* name, const double(&v)[3]) -> std::string {
    for (const double x : v)
      if (!std::isfinite(x)) return fmt::format("{} is ({:g}, {:g}, {:g})", name, v[0], v[1], v[2]);
    return "";
  };
  for (const std::string& text : {bad("position", plane.point), bad("normal", plane.normal),
                                  bad("velocity", plane.velocity), bad("velocity", plane.mid_velocity)})
    if (!text.empty()) return text;
  const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
  // Round-off of a normalisation, with a margin.
  return std::abs(length - 1) > 1e-9 ? fmt::format("normal has length {:g}", length) : "";
}

namespace {

std::string problem_of_turn(const scree_linear_wall& wall) {
  const double length = std::hypot(wall.axis[0], wall.axis[1], wall.axis[2]);
  if (!(std::abs(length - 1) < 1e-9)) return fmt::format("an axis of length {:g}", length);
  for (const double x : wall.centre)
    if (!std::isfinite(x)) return fmt::format("a centre at {:g} m", x);
  if (!(wall.inertia >= 0 && std::isfinite(wall.inertia)))
    return fmt::format("an inertia of {:g} kg m^2", wall.inertia);
  if (!(wall.spin_viscosity >= 0 && std::isfinite(wall.spin_viscosity)))
    return fmt::format("a spin viscosity of {:g} N m s", wall.spin_viscosity);
  if (!std::isfinite(wall.pressing_torque))
    return fmt::format("a pressing torque of {:g} N m", wall.pressing_torque);
  return "";
}

}  // namespace

std::string problem_of(const scree_linear_wall& wall, std::span<const double> stiffness) {
  const double length = std::hypot(wall.direction[0], wall.direction[1], wall.direction[2]);
  if (!(std::abs(length - 1) < 1e-9)) return fmt::format("a direction of length {:g}", length);
  if (!std::isfinite(wall.speed)) return fmt::format("a speed of {:g} m/s", wall.speed);
  if (wall.free > SCREE_NO_EQUATION) return fmt::format("the unknown freedom {}", wall.free);
  if (const std::string problem = wall.turns ? problem_of_turn(wall) : ""; !problem.empty()) return problem;
  if (wall.free != SCREE_FREE) return "";
  if (!std::isfinite(wall.pressing_force))
    return fmt::format("a pressing force of {:g} N", wall.pressing_force);
  if (!(wall.mass >= 0 && std::isfinite(wall.mass))) return fmt::format("a mass of {:g} kg", wall.mass);
  if (!(wall.viscosity >= 0 && std::isfinite(wall.viscosity)))
    return fmt::format("a viscosity of {:g} kg/s", wall.viscosity);
  for (const double k : stiffness)
    if (!std::isfinite(k)) return fmt::format("a stiffness of {:g} N/m", k);
  return "";
}

}  // namespace scree
