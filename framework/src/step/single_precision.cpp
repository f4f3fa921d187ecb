#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/single_precision.hpp>
#include <scree/step_guard.hpp>

namespace scree {

namespace {

// From 1.2e-38 to 3.4e38, less the factors by which values in a run differ from the typical ones.
constexpr double least = 1e-34, most = 1e36;

struct Magnitude {
  const char* name;
  double smallest, largest;
  const char* unit;
};

double square(double x) { return x * x; }

}  // namespace

std::optional<std::string> single_precision_problem(const Scene& scene) {
  if (scene.bodies.empty()) return {};
  const double speed = expected_speed(scene), contact = shortest_contact_time(scene, speed);
  if (!std::isfinite(contact)) return {};
  const auto mass = [](const Body& a, const Body& b) { return a.mass < b.mass; };
  const auto radius = [](const Body& a, const Body& b) { return a.radius < b.radius; };
  const auto masses = std::minmax_element(scene.bodies.begin(), scene.bodies.end(), mass);
  const auto radii = std::minmax_element(scene.bodies.begin(), scene.bodies.end(), radius);
  // Typical of a contact at that speed and of that duration; laws square overlaps, springs and forces.
  const auto of_mass = [&](const char* name, double factor, const char* unit) {
    return Magnitude{name, masses.first->mass * factor, masses.second->mass * factor, unit};
  };
  const auto force = of_mass("", speed / contact, "");
  for (const Magnitude& m :
       {Magnitude{"a radius", radii.first->radius, radii.second->radius, "m"}, of_mass("a mass", 1, "kg"),
        Magnitude{"the square of the time step", square(scene.step), square(scene.step), "s^2"},
        Magnitude{"the square of an overlap", square(speed * contact), square(speed * contact), "m^2"},
        of_mass("a stiffness", 1 / square(contact), "N/m"),
        Magnitude{"the square of a force", square(force.smallest), square(force.largest), "N^2"},
        of_mass("an energy", square(speed), "J"), of_mass("a power", square(speed) / contact, "W")})
    if (!(m.smallest >= least) || !(m.largest <= most))
      return fmt::format(
          "at {:.3g} m/s, {} of some {:.2g} {} is outside {:g} to {:g}, the range of single precision", speed,
          m.name, m.smallest >= least ? m.largest : m.smallest, m.unit, least, most);
  return {};
}

}  // namespace scree
