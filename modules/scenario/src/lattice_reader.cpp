#include "lattice_reader.hpp"

#include "plugin_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/packing/lattice.hpp>

namespace scree::scenario {

namespace {

// Peak memory (bytes) per body from reading to running, including neighbours and contacts.
constexpr double memory_per_body = 2000;

packing::ListedRadius read_list(const document::Table& t) {
  packing::ListedRadius list = {t.numbers("radii", document::Range::positive("m")), {}};
  if (t.has("weights"))
    list.weights = t.numbers("weights", list.radii.size(), document::Range::non_negative());
  return list;
}

packing::RadiusDistribution read_distribution(const document::Table& t) {
  const document::Range length = document::Range::positive("m");
  const std::string kind = t.choice("distribution", {"constant", "uniform", "normal", "bidisperse", "list"});
  if (kind == "constant") return packing::ConstantRadius{t.number("radius", length)};
  if (kind == "uniform")
    return packing::UniformRadius{t.number("minimum", length), t.number("maximum", length)};
  if (kind == "normal") {
    const double mean = t.number("mean", length);
    const double deviation = t.number("standard_deviation", document::Range::non_negative("m"));
    return packing::NormalRadius{mean, deviation, t.number("minimum", length),
                                 t.number("maximum", 2 * mean + 10 * deviation, length)};
  }
  if (kind == "bidisperse")
    return packing::BidisperseRadius{t.number("small", length), t.number("large", length),
                                     t.number("large_fraction", document::Range::between(0, 1))};
  return read_list(t);
}

packing::RadiusDistribution read_radius(const document::Table& particles) {
  if (!particles.is_table("radius"))
    return packing::ConstantRadius{particles.number("radius", document::Range::positive("m"))};
  const packing::RadiusDistribution distribution = read_distribution(particles.table("radius"));
  placed(particles, "radius", [&] { packing::check(distribution); });
  return distribution;
}

// Checked before anything is allocated: a system without memory kills a program without a message.
void check_memory(const document::Table& t, double bodies) {
  const double there = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  if (bodies * memory_per_body > there)
    throw t.error("count",
                  fmt::format("{:g} bodies need about {:.3g} GB of memory, but this computer has {:.3g} GB",
                              bodies, 1e-9 * bodies * memory_per_body, 1e-9 * there),
                  fmt::format("give at most {:.2g}", there / memory_per_body));
}

std::array<std::int64_t, 3> read_count(const document::Table& t, int dimension) {
  std::array<std::int64_t, 3> count = {1, 1, 1};
  const std::vector<double> numbers =
      t.numbers("count", std::size_t(dimension), document::Range::at_least(1));
  double bodies = 1;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] != std::floor(numbers[k]))
      throw t.error("count", k, fmt::format("count {:g} is not a whole number", numbers[k]),
                    "give whole numbers such as 7");
    bodies *= numbers[k];
  }
  check_memory(t, bodies);
  std::transform(numbers.begin(), numbers.end(), count.begin(), [](double n) { return std::int64_t(n); });
  return count;
}

packing::LatticeOptions read_lattice(const document::Table& t, int dimension) {
  packing::LatticeOptions options;
  const std::vector<std::string> kinds =
      dimension == 3 ? std::vector<std::string>{"simple_cubic", "face_centred_cubic", "hexagonal_close"}
                     : std::vector<std::string>{"square", "triangular"};
  options.kind = packing::lattice_kind(t.choice("kind", kinds, kinds[0]));
  if (t.is_array("count")) {
    options.count = read_count(t, dimension);
  } else {
    options.total = t.integer("count", document::Range::at_least(1));
    check_memory(t, double(*options.total));
  }
  options.spacing = t.optional_number("spacing", document::Range::positive("m"));
  options.gap = t.number("gap", 0.0, document::Range::non_negative());
  options.displacement = t.number("displacement", 0.0, document::Range::non_negative("m"));
  options.origin = read_vector(t, "origin", dimension, false);
  options.centred = t.boolean("centred", false);
  return options;
}

}  // namespace

packing::Packing read_lattice_bodies(const document::Table& particles, int dimension,
                                     packing::Random& random) {
  const packing::RadiusDistribution radii = read_radius(particles);
  const packing::LatticeOptions options = read_lattice(particles.table("lattice"), dimension);
  return placed(particles, "lattice", [&] { return packing::fill_lattice(options, radii, random); });
}

Vec3 read_vector(const document::Table& table, std::string_view key, int dimension, bool required) {
  Vec3 v = {};
  if (!required && !table.has(key)) return v;
  const std::vector<double> numbers = table.numbers(key, std::size_t(dimension));
  std::copy(numbers.begin(), numbers.end(), v.component);
  return v;
}

}  // namespace scree::scenario
