#include "particles_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

#include <scree/nearest.hpp>
#include <scree/packing/import.hpp>
#include <scree/packing/lattice.hpp>

#include "plugin_parameters.hpp"

namespace scree::scenario {

namespace {

using packing::Packing;

Vec3 read_vector(const Table& table, std::string_view key, int dimension, bool required) {
  Vec3 v = {};
  if (!required && !table.has(key)) return v;
  const std::vector<double> numbers = table.numbers(key, std::size_t(dimension));
  std::copy(numbers.begin(), numbers.end(), v.component);
  return v;
}

packing::RadiusDistribution read_distribution(const Table& t) {
  const Range length = Range::positive("m");
  const std::string kind = t.choice("distribution", {"constant", "uniform", "normal", "bidisperse", "list"});
  if (kind == "constant") return packing::ConstantRadius{t.number("radius", length)};
  if (kind == "uniform") return packing::UniformRadius{t.number("minimum", length), t.number("maximum", length)};
  if (kind == "normal") {
    const double mean = t.number("mean", length), deviation = t.number("standard_deviation", Range::non_negative("m"));
    return packing::NormalRadius{mean, deviation, t.number("minimum", length),
                                 t.number("maximum", 2 * mean + 10 * deviation, length)};
  }
  if (kind == "bidisperse")
    return packing::BidisperseRadius{t.number("small", length), t.number("large", length),
                                     t.number("large_fraction", Range::between(0, 1))};
  return packing::ListedRadius{t.numbers("radii", length), t.numbers_or("weights", {}, Range::non_negative())};
}

packing::RadiusDistribution read_radius(const Table& particles) {
  if (!particles.is_table("radius"))
    return packing::ConstantRadius{particles.number("radius", Range::positive("m"))};
  return placed(particles, "radius", [&] {
    packing::RadiusDistribution d = read_distribution(particles.table("radius"));
    packing::check(d);
    return d;
  });
}

packing::LatticeOptions read_lattice(const Table& t, int dimension) {
  packing::LatticeOptions options;
  const std::vector<std::string> kinds = dimension == 3
                                             ? std::vector<std::string>{"simple_cubic", "face_centred_cubic", "hexagonal_close"}
                                             : std::vector<std::string>{"square", "triangular"};
  options.kind = packing::lattice_kind(t.choice("kind", kinds, kinds[0]));
  if (t.is_array("count")) {
    std::array<std::int64_t, 3> count = {1, 1, 1};
    const std::vector<double> numbers = t.numbers("count", std::size_t(dimension), Range::at_least(1));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers[k] != std::floor(numbers[k]) || numbers[k] > 1e8)
        throw t.error("count", k, fmt::format("count {:g} is no whole number of bodies", numbers[k]), "give numbers such as 7");
      count[k] = std::int64_t(numbers[k]);
    }
    options.count = count;
  } else {
    options.total = t.integer("count", Range::at_least(1));
  }
  options.spacing = t.optional_number("spacing", Range::positive("m"));
  options.gap = t.number("gap", 0.0, Range::non_negative());
  options.displacement = t.number("displacement", 0.0, Range::non_negative("m"));
  options.origin = read_vector(t, "origin", dimension, false);
  options.centred = t.boolean("centred", false);
  return options;
}

Packing read_source(const Table& particles, int dimension, packing::Random& random, const std::filesystem::path& folder,
                    const std::vector<Material>& materials) {
  if (particles.has("file") && particles.has("lattice"))
    throw particles.error("file", "both a file and a lattice are given", "keep one of them");
  if (particles.has("file")) {
    packing::ImportOptions options;
    options.dimension = dimension;
    for (const Material& material : materials) options.materials.push_back(material.name);
    if (const auto timestep = particles.optional_integer("timestep")) options.timestep = *timestep;
    const std::string file = particles.string("file");
    return placed(particles, "file", [&] { return packing::read_packing(folder / file, options); });
  }
  const packing::RadiusDistribution radii = read_radius(particles);
  return placed(particles, "lattice", [&] {
    return packing::fill_lattice(read_lattice(particles.table("lattice"), dimension), radii, random);
  });
}

packing::Body read_inline(const Table& t, int dimension) {
  packing::Body body;
  body.id = t.integer("id", 0, Range::positive());
  body.material = t.string("material", "");
  body.radius = t.number("radius", Range::positive("m"));
  if (const auto density = t.optional_number("density", Range::positive("kg/m^3"))) body.density = *density;
  if (const auto mass = t.optional_number("mass", Range::positive("kg"))) body.mass = *mass;
  if (!std::isnan(body.density) && !std::isnan(body.mass))
    throw t.error("mass", "mass and density are both given", "keep one of them");
  body.position = read_vector(t, "position", dimension, true);
  body.velocity = read_vector(t, "velocity", dimension, false);
  if (dimension == 2)
    body.spin[2] = t.number("spin", 0.0);
  else
    body.spin = read_vector(t, "spin", dimension, false);
  return body;
}

std::uint32_t material_index(const Table& place, const std::string& name, const std::vector<Material>& materials) {
  if (name.empty() && materials.size() == 1) return 0;
  std::vector<std::string> names;
  for (std::uint32_t k = 0; k < materials.size(); ++k) {
    if (materials[k].name == name) return k;
    names.push_back(materials[k].name);
  }
  const auto near = nearest_word(name, names);
  throw place.error("material", name.empty() ? "no material is given, and there are several" : fmt::format("no material '{}'", name),
                    near ? fmt::format("did you mean '{}'?", *near)
                         : fmt::format("name one of the [[material]]s: {}", fmt::join(names, ", ")));
}

Body complete(const packing::Body& from, std::uint32_t material, int dimension, double density) {
  Body body = {.id = from.id, .material = material, .radius = from.radius};
  body.position = from.position;
  body.velocity = from.velocity;
  body.spin = from.spin;
  const double r = from.radius;
  const double volume = dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
  body.mass = !std::isnan(from.mass) ? from.mass : volume * (std::isnan(from.density) ? density : from.density);
  body.inertia = (dimension == 2 ? 0.5 : 0.4) * body.mass * r * r;
  return body;
}

// Ids that were not given follow the largest that was.
void number_bodies(const Table& root, std::vector<Body>& bodies) {
  std::set<std::int64_t> used;
  for (const Body& body : bodies)
    if (body.id > 0 && !used.insert(body.id).second)
      throw root.error("particle", fmt::format("two bodies have the id {}", body.id), "give each id once, or none");
  std::int64_t next = used.empty() ? 1 : *used.rbegin() + 1;
  for (Body& body : bodies)
    if (body.id <= 0) body.id = next++;
}

}  // namespace

std::vector<Body> read_bodies(const Table& root, int dimension, const std::vector<Material>& materials,
                              std::uint64_t seed, const std::filesystem::path& folder) {
  std::vector<Body> bodies;
  packing::Random random(seed);
  if (const auto particles = root.optional_table("particles")) {
    const std::string material = particles->string("material", "");
    const double agitation = particles->number("random_velocity", 0.0, Range::non_negative("m/s"));
    const Vec3 velocity = read_vector(*particles, "velocity", dimension, false);
    for (packing::Body& from : read_source(*particles, dimension, random, folder, materials).bodies) {
      const std::uint32_t index = material_index(*particles, from.material.empty() ? material : from.material, materials);
      from.velocity += velocity;
      for (int k = 0; k < dimension && agitation > 0; ++k) from.velocity[k] += agitation * random.normal();
      bodies.push_back(complete(from, index, dimension, materials[index].density));
    }
  }
  for (const Table& t : root.tables("particle")) {
    const packing::Body from = read_inline(t, dimension);
    const std::uint32_t index = material_index(t, from.material, materials);
    bodies.push_back(complete(from, index, dimension, materials[index].density));
  }
  number_bodies(root, bodies);
  return bodies;
}

}  // namespace scree::scenario
