#include "particles_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/packing/lattice.hpp>

namespace scree::scenario {

namespace {

// Peak memory (bytes) per body from reading to running, including neighbours and contacts.
constexpr double memory_per_body = 2000;

packing::ListedRadius read_list(const document::Table& t) {
  packing::ListedRadius list = {t.numbers(radius_keys.radii, radius_keys.radii.range), {}};
  if (t.optional(radius_keys.weights))
    list.weights = t.numbers(radius_keys.weights, list.radii.size(), radius_keys.weights.range);
  return list;
}

packing::RadiusDistribution read_distribution(const document::Table& t) {
  const RadiusKeys& keys = radius_keys;
  const std::string kind = read(t, keys.distribution);
  if (kind == "constant") return packing::ConstantRadius{read(t, keys.radius)};
  if (kind == "uniform") return packing::UniformRadius{read(t, keys.minimum), read(t, keys.maximum)};
  if (kind == "normal") {
    const double mean = read(t, keys.mean), deviation = read(t, keys.standard_deviation);
    return packing::NormalRadius{mean, deviation, read(t, keys.minimum),
                                 read_optional(t, keys.maximum).value_or(2 * mean + 10 * deviation)};
  }
  if (kind == "bidisperse")
    return packing::BidisperseRadius{read(t, keys.small), read(t, keys.large), read(t, keys.large_fraction)};
  return read_list(t);
}

std::array<std::int64_t, 3> read_count(const document::Table& t, int dimension) {
  std::array<std::int64_t, 3> count = {1, 1, 1};
  const std::vector<double> numbers =
      t.numbers(lattice_keys.count, std::size_t(dimension), lattice_keys.count.range);
  double bodies = 1;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] != std::floor(numbers[k]))
      throw t.error("count", k, fmt::format("count {:g} is not a whole number", numbers[k]),
                    "give whole numbers such as 7");
    bodies *= numbers[k];
  }
  check_body_memory(t, "count", bodies);
  std::transform(numbers.begin(), numbers.end(), count.begin(), [](double n) { return std::int64_t(n); });
  return count;
}

packing::LatticeOptions read_lattice(const document::Table& t, int dimension) {
  packing::LatticeOptions options;
  const std::vector<std::string> kinds =
      dimension == 3 ? std::vector<std::string>{"simple_cubic", "face_centred_cubic", "hexagonal_close"}
                     : std::vector<std::string>{"square", "triangular"};
  options.kind = packing::lattice_kind(t.choice(lattice_keys.kind, kinds, kinds[0]));
  if (t.is_array("count")) {
    options.count = read_count(t, dimension);
  } else {
    options.total = read(t, lattice_keys.count);
    check_body_memory(t, "count", double(*options.total));
  }
  options.spacing = read_optional(t, lattice_keys.spacing);
  options.gap = read(t, lattice_keys.gap);
  options.displacement = read(t, lattice_keys.displacement);
  options.origin = read_vector(t, lattice_keys.origin, dimension, false);
  options.centred = read(t, lattice_keys.centred);
  return options;
}

}  // namespace

packing::RadiusDistribution read_radius(const document::Table& particles) {
  if (!particles.is_table("radius")) return packing::ConstantRadius{read(particles, particles_keys.radius)};
  const packing::RadiusDistribution distribution = read_distribution(particles.table("radius"));
  placed(particles, "radius", [&] { packing::check(distribution); });
  return distribution;
}

packing::Packing read_lattice_bodies(const document::Table& particles, int dimension, packing::Random& random,
                                     std::string& origin) {
  const packing::RadiusDistribution radii = read_radius(particles);
  const packing::LatticeOptions options = read_lattice(particles.table("lattice"), dimension);
  origin = fmt::format("of a lattice, {}", packing::lattice_name(options.kind));
  return placed(particles, "lattice", [&] { return packing::fill_lattice(options, radii, random); });
}

Vec3 read_vector(const document::Table& table, std::string_view key, int dimension, bool required) {
  Vec3 v = {};
  if (!required && !table.optional(key)) return v;
  const std::vector<double> numbers = table.numbers(key, std::size_t(dimension));
  std::copy(numbers.begin(), numbers.end(), v.component);
  return v;
}

void check_body_memory(const document::Table& table, std::string_view key, double bodies) {
  const double there = available_memory();
  if (bodies * memory_per_body > there)
    throw table.error(
        key,
        fmt::format("{:g} bodies need about {:.3g} GB of memory, but this computer has {:.3g} GB", bodies,
                    1e-9 * bodies * memory_per_body, 1e-9 * there),
        fmt::format("give at most {:.2g}", there / memory_per_body));
}

}  // namespace scree::scenario
