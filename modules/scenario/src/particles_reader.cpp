#include "particles_reader.hpp"

#include "body_memory.hpp"
#include "lattice_reader.hpp"
#include "particles_keys.hpp"
#include "plugin_parameters.hpp"
#include "state_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include <scree/packing/import.hpp>
#include <scree/plugin/abi.h>
#include <scree/scenario/names.hpp>
#include <scree/spatial_order.hpp>

namespace scree::scenario {

namespace {

packing::Packing read_file(const document::Table& particles, int dimension,
                           const std::filesystem::path& folder, const std::vector<Material>& materials) {
  packing::ImportOptions options;
  // In a three-dimensional scene the file decides, so that a two-dimensional packing is detected below.
  if (dimension == 2) options.dimension = dimension;
  options.materials = names_of(materials);
  options.timestep = particles.optional_integer(particles_keys.timestep);
  const std::string file = read(particles, particles_keys.file);
  packing::Packing read =
      placed(particles, "file", [&] { return packing::read_packing(folder / file, options); });
  if (read.dimension != dimension)
    throw particles.error("file", "the packing has two dimensions and the scene three",
                          "set scene.dimension = 2, or give a packing with z");
  return read;
}

// Repeats a periodic packing along each axis, one period apart.
void repeat(const document::Table& particles, int dimension, packing::Packing& packing) {
  if (!particles.optional(particles_keys.repeat)) {
    if (particles.has(particles_keys.period))
      throw particles.error("period",
                            "'period' is the distance of copies, of which 'repeat' gives the number",
                            "add repeat, such as [5, 1, 5], or remove it");
    return;
  }
  const std::vector<double> times =
      particles.numbers(particles_keys.repeat, std::size_t(dimension), particles_keys.repeat.range);
  const std::vector<double> period =
      particles.numbers(particles_keys.period, std::size_t(dimension), particles_keys.period.range);
  double bodies = double(packing.bodies.size());
  for (const double n : times) {
    if (n != std::floor(n))
      throw particles.error("repeat", fmt::format("{:g} is not a whole number", n),
                            "give counts, such as [5, 1, 5]");
    bodies *= n;
  }
  check_body_memory(particles, "repeat", bodies);
  for (int k = 0; k < dimension; ++k) {
    const std::size_t original = packing.bodies.size();
    for (int n = 1; n < int(times[std::size_t(k)]); ++n)
      for (std::size_t i = 0; i < original; ++i) {
        packing::Body copy = packing.bodies[i];
        copy.id = 0;
        copy.position[k] += n * period[std::size_t(k)];
        packing.bodies.push_back(copy);
      }
    if (packing.bounds) packing.bounds->upper[k] += (times[std::size_t(k)] - 1) * period[std::size_t(k)];
  }
}

// These select or copy bodies of a file.
void refuse_keys_of_files(const document::Table& particles) {
  for (const Key& key : {Key(particles_keys.timestep), particles_keys.repeat, particles_keys.period})
    if (particles.has(key))
      throw particles.error(key, fmt::format("'{}' needs 'file', which is not given", key.name),
                            "add file = \"<path>\", or remove it; the size of a lattice is its count");
}

packing::Packing read_source(const document::Table& particles, int dimension, packing::Random& random,
                             const std::filesystem::path& folder, const std::vector<Material>& materials) {
  if (!particles.optional(particles_keys.file)) {
    refuse_keys_of_files(particles);
    return read_lattice_bodies(particles, dimension, random);
  }
  if (particles.optional(particles_keys.lattice))
    throw particles.error("file", "both a file and a lattice are given", "keep one of them");
  packing::Packing packing = read_file(particles, dimension, folder, materials);
  repeat(particles, dimension, packing);
  return packing;
}

packing::Body read_inline(const document::Table& t, int dimension) {
  packing::Body body;
  body.id = read(t, particle_keys.id);
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

// Adds material, mass and inertia to a body. Throws Error at `t` unless both are positive and finite.
Body complete(const document::Table& t, const packing::Body& from, int dimension,
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

// Adds the [[particle]]s; their ids must differ from those of other bodies.
void add_inline(const document::Table& root, int dimension, const std::vector<Material>& materials,
                std::vector<Body>& bodies) {
  std::set<std::int64_t> used;
  for (const Body& body : bodies) used.insert(body.id);
  for (const document::Table& t : root.tables("particle")) {
    bodies.push_back(complete(t, read_inline(t, dimension), dimension, materials));
    if (t.has(particle_keys.id) && !used.insert(bodies.back().id).second)
      throw t.error("id", fmt::format("two bodies have the id {}", bodies.back().id),
                    "give every body a different id, or no id");
  }
}

// Bodies without an id are numbered after the largest given id.
void number_bodies(const document::Table& root, std::vector<Body>& bodies) {
  std::int64_t last = 0;
  for (const Body& body : bodies) last = std::max(last, body.id);
  for (Body& body : bodies) {
    if (body.id > 0) continue;
    if (last == SCREE_MAX_ID)
      throw root.error("no id is left for a body without one, because ids end at 1e15",
                       "give that body an id, or use smaller ones");
    body.id = ++last;
  }
}

// Small scenes fit into the caches anyway and keep the order of the file.
constexpr std::size_t min_bodies_to_sort = 1024;

void sort_in_space(std::vector<Body>& bodies, int dimension) {
  if (bodies.size() < min_bodies_to_sort) return;
  std::vector<Body> sorted;
  for (const std::uint32_t i : spatial_order(bodies, dimension)) sorted.push_back(bodies[i]);
  bodies = std::move(sorted);
}

void refuse_without_state(const document::Table& particles) {
  if (particles.has(particles_keys.leave_out))
    throw particles.error(particles_keys.leave_out, "'leave_out' needs 'state', which is not given",
                          "add state = \"<path>\", or remove it");
}

// What [particles] adds to the velocities of its bodies.
class AddedVelocity {
 public:
  AddedVelocity(const document::Table& particles, int dimension)
      : velocity_(read_vector(particles, particles_keys.velocity, dimension, false)),
        gradient_(read_vector(particles, particles_keys.velocity_gradient, dimension, false)),
        deviation_(read(particles, particles_keys.random_velocity)),
        dimension_(dimension) {}

  // At a position (m).
  Vec3 at(const Vec3& position, packing::Random& random) const {
    Vec3 added = velocity_;
    for (int k = 0; k < dimension_; ++k) {
      added[k] += gradient_[k] * position[k];
      if (deviation_ > 0) added[k] += deviation_ * random.normal();
    }
    return added;
  }

 private:
  Vec3 velocity_, gradient_;
  double deviation_;
  int dimension_;
};

// Bodies keep the order of the state, by which its contacts number them.
ReadBodies read_bodies_of_state(const document::Table& root, const document::Table& particles, int dimension,
                                const std::vector<Material>& materials, std::uint64_t seed,
                                const std::filesystem::path& folder) {
  for (const Key& key : {Key(particles_keys.file), particles_keys.lattice, Key(particles_keys.radius),
                         Key(particles_keys.timestep), particles_keys.repeat, particles_keys.period,
                         Key(particles_keys.material)})
    if (particles.has(key))
      throw particles.error(key, fmt::format("both state and {} are given", key.name), "keep one of them");
  ReadBodies read_bodies;
  read_bodies.state = read_state(particles, folder);
  read_bodies.branching = read_branching(particles);
  std::vector<Body>& bodies = read_bodies.bodies;
  bodies = bodies_of(particles, *read_bodies.state, materials);
  packing::Random random(seed);
  const AddedVelocity added(particles, dimension);
  for (Body& body : bodies) body.velocity += added.at(body.position, random);
  add_inline(root, dimension, materials, bodies);
  number_bodies(root, bodies);
  return read_bodies;
}

}  // namespace

ReadBodies read_bodies(const document::Table& root, int dimension, const std::vector<Material>& materials,
                       std::uint64_t seed, const std::filesystem::path& folder) {
  if (const auto particles = root.optional_table("particles");
      particles && particles->optional(particles_keys.state))
    return read_bodies_of_state(root, *particles, dimension, materials, seed, folder);
  Domain box;
  std::vector<Body> bodies;
  packing::Random random(seed);
  if (const auto particles = root.optional_table("particles")) {
    refuse_without_state(*particles);
    const std::string material = read(*particles, particles_keys.material);
    const AddedVelocity added(*particles, dimension);
    packing::Packing source = read_source(*particles, dimension, random, folder, materials);
    if (source.bounds) box = {source.periodic, source.bounds->lower, source.bounds->upper};
    for (packing::Body& from : source.bodies) {
      if (from.material.empty()) from.material = material;
      from.velocity += added.at(from.position, random);
      bodies.push_back(complete(*particles, from, dimension, materials));
    }
  }
  add_inline(root, dimension, materials, bodies);
  number_bodies(root, bodies);
  sort_in_space(bodies, dimension);
  if (bodies.empty())
    throw root.error("the scene has no bodies",
                     "add [particles] with lattice and radius, file or state, or [[particle]]");
  return {std::move(bodies), box};
}

}  // namespace scree::scenario
