#include "particles_keys.hpp"
#include "readers.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace scree::scenario {

namespace {

packing::Body read_inline(const document::Table& t, int dimension) {
  packing::Body body;
  body.id = t.optional_integer(particle_keys.id, particle_keys.id.range).value_or(0);
  body.material = read(t, particle_keys.material);
  body.radius = read(t, particle_keys.radius);
  if (const auto density = read_optional(t, particle_keys.density)) body.density = *density;
  if (const auto mass = read_optional(t, particle_keys.mass)) body.mass = *mass;
  if (!std::isnan(body.density) && !std::isnan(body.mass))
    throw t.error("mass", "mass and density are both given", "keep one of them");
  body.position = read_vector(t, particle_keys.position, dimension, true);
  body.velocity = read_vector(t, particle_keys.velocity, dimension, false);
  if (dimension == 2)
    body.spin[2] = t.number(particle_keys.spin, 0.0);
  else
    body.spin = read_vector(t, particle_keys.spin, dimension, false);
  return body;
}

std::uint32_t material_index(const document::Table& t, const std::string& name,
                             const std::vector<Material>& materials) {
  if (name.empty() && materials.size() == 1) return 0;
  const std::vector<std::string> names = names_of(materials);
  if (name.empty())
    throw t.error("no material is given, but the scene has several",
                  fmt::format("add material = \"{}\" or another", names[0]));
  return std::uint32_t(find_name(t, "material", "material", name, names));
}

}  // namespace

Body complete_body(const document::Table& t, const packing::Body& from, int dimension,
                   const std::vector<Material>& materials) {
  Body body = {.id = from.id, .material = material_index(t, from.material, materials), .radius = from.radius};
  body.position = from.position;
  body.velocity = from.velocity;
  body.spin = from.spin;
  if (!std::isfinite(norm(from.position)) || !std::isfinite(norm(from.velocity)) ||
      !std::isfinite(norm(from.spin)))
    throw t.error(
        fmt::format("a body at ({:g}, {:g}, {:g}) m, or its velocity or spin, is outside the range of "
                    "numbers (1e154)",
                    from.position[0], from.position[1], from.position[2]),
        "check position, spacing, period and velocity");
  const double r = from.radius;
  const double volume = dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const double density = std::isnan(from.density) ? materials[body.material].density : from.density;
  body.mass = std::isnan(from.mass) ? volume * density : from.mass;
  body.inertia = (dimension == 2 ? 0.5 : 0.4) * body.mass * r * r;
  if (!std::isnormal(body.mass) || !std::isnormal(body.inertia)) {
    const bool given = !std::isnan(from.mass);
    throw t.error(
        given ? "mass" : "radius",
        fmt::format("a radius of {:g} m with a {} gives a body of {:g} kg and {:g} kg m^2, outside the range "
                    "of numbers",
                    r,
                    given ? fmt::format("mass of {:g} kg", from.mass)
                          : fmt::format("density of {:g} kg/m^3", density),
                    body.mass, body.inertia),
        given ? "check the units of radius (m) and mass (kg)"
              : "check the units of radius (m) and density (kg/m^3)");
  }
  return body;
}

Body read_single_body(const document::Table& particle, int dimension,
                      const std::vector<Material>& materials) {
  return complete_body(particle, read_inline(particle, dimension), dimension, materials);
}

}  // namespace scree::scenario
