#include "close_pairs.hpp"
#include "lattice_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_reader.hpp>
#include <scree/packing/lattice.hpp>

namespace scree::packing {

namespace {

constexpr std::array<std::string_view, 5> names = {"simple_cubic", "face_centred_cubic", "hexagonal_close",
                                                   "square", "triangular"};

void require_length(double value, std::string_view what) {
  if (std::isfinite(value) && value >= 0.0) return;
  throw Error("lattice", fmt::format("{} {} is negative or not finite", what, value), "give 0 or more");
}

// Number of sites. Each factor is checked against the limit first, as the product could overflow.
std::int64_t require_count(const SiteCount& count, LatticeKind kind) {
  std::int64_t product = 1;
  for (int k = 0; k < 3; ++k) {
    if (count[k] < 1)
      throw Error("lattice", fmt::format("{} sites along {}", count[k], "xyz"[k]), "give at least 1");
    if (count[k] > max_lattice_sites / product)
      throw Error("lattice", fmt::format("more than {} sites", max_lattice_sites), "give smaller counts");
    product *= count[k];
  }
  if (lattice_dimension(kind) == 2 && count[2] != 1)
    throw Error("lattice", fmt::format("{} has {} sites along z", lattice_name(kind), count[2]),
                "it is two-dimensional, give 1");
  return product;
}

SiteCount resolve_count(const LatticeOptions& options) {
  if (options.count.has_value() == options.total.has_value())
    throw Error("lattice", "give either the counts along the axes or the total number of bodies", "");
  if (options.count) return *options.count;
  if (*options.total < 1 || *options.total > max_lattice_sites)
    throw Error("lattice", fmt::format("total of {} bodies", *options.total),
                fmt::format("give 1 to {}", max_lattice_sites));
  return nearest_count(options.kind, *options.total, options.periodic);
}

void require_closure(const LatticeOptions& options, const SiteCount& count) {
  const auto staggered = staggered_axes(options.kind);
  for (int k = 0; k < 3; ++k) {
    if (!options.periodic[k]) continue;
    if (k >= lattice_dimension(options.kind))
      throw Error("lattice",
                  fmt::format("{} cannot be periodic along {}", lattice_name(options.kind), "xyz"[k]),
                  "it is two-dimensional");
    if (staggered[k] && count[k] % 2 != 0)
      throw Error("lattice",
                  fmt::format("{} with {} rows along {} does not close periodically",
                              lattice_name(options.kind), count[k], "xyz"[k]),
                  "give an even number");
  }
}

double resolve_spacing(const LatticeOptions& options, double largest_radius) {
  if (!options.spacing) return 2.0 * largest_radius * (1.0 + options.gap) + 2.0 * options.displacement;
  if (std::isfinite(*options.spacing) && *options.spacing > 0.0) return *options.spacing;
  throw Error("lattice", fmt::format("spacing {} m is not positive and finite", *options.spacing),
              "give a number above 0");
}

// Along open axes the margin keeps the outer bodies inside for any displacement; along periodic axes it is
// half a lattice step on either side.
struct Box {
  Bounds bounds;
  Vec3 first_site;  // (m)
};

Box resolve_box(const LatticeOptions& options, const SiteCount& count, double spacing,
                double largest_radius) {
  const Vec3 step = lattice_step(options.kind);
  const Vec3 extent = lattice_extent(options.kind, count);
  Box box{};
  for (int k = 0; k < lattice_dimension(options.kind); ++k) {
    const double margin = options.periodic[k]
                              ? 0.5 * step[k] * spacing
                              : std::max(0.5 * spacing, largest_radius + options.displacement);
    const double length =
        options.periodic[k] ? double(count[k]) * step[k] * spacing : extent[k] * spacing + 2.0 * margin;
    box.bounds.lower[k] = options.centred ? options.origin[k] - 0.5 * length : options.origin[k];
    box.bounds.upper[k] = box.bounds.lower[k] + length;
    box.first_site[k] = box.bounds.lower[k] + margin;
  }
  return box;
}

void place_bodies(Packing& packing, const LatticeOptions& options, const SiteCount& count, const Box& box,
                  double spacing, const std::vector<double>& radii, Random& random) {
  for (std::size_t n = 0; n < radii.size(); ++n) {
    const auto site = std::int64_t(n);
    const SiteCount index = {site % count[0], site / count[0] % count[1], site / count[0] / count[1]};
    Body body;
    body.id = options.first_id + site;
    body.material = options.material;
    body.radius = radii[n];
    body.density = options.density;
    body.position = box.first_site + spacing * lattice_site(options.kind, index);
    if (packing.dimension == 2) body.position[2] = 0.0;
    if (options.displacement > 0.0) body.position += random.in_ball(options.displacement, packing.dimension);
    packing.bodies.push_back(std::move(body));
  }
}

// Overlap (m) that rounding of the coordinates can produce.
double rounding_depth(const Bounds& bounds) {
  double farthest = 0.0;
  for (int k = 0; k < 3; ++k)
    farthest = std::max({farthest, std::abs(bounds.lower[k]), std::abs(bounds.upper[k])});
  return 16.0 * std::numeric_limits<double>::epsilon() * farthest;
}

// Rounds up to six significant digits; a value that is such a number within rounding error is kept.
double rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 5.0);
  return std::ceil(value / unit * (1.0 - 4.0 * std::numeric_limits<double>::epsilon())) * unit;
}

[[noreturn]] void fail_overlap(const Packing& packing, const ClosePair& pair, double sufficient_spacing) {
  const Body& a = packing.bodies[pair.first];
  const Body& b = packing.bodies[pair.second];
  const double depth = a.radius + b.radius - pair.distance;
  throw Error(
      "lattice",
      fmt::format("bodies {} and {} overlap by {:.6g} m", std::min(a.id, b.id), std::max(a.id, b.id), depth),
      fmt::format("give a spacing of at least {:.6g} m", rounded_up(sufficient_spacing)));
}

// Without displacement every distance is proportional to the spacing, so the largest ratio of required to
// actual distance gives the minimum spacing. With displacement, or after too many overlaps, the message gives
// the spacing that is always sufficient.
void refuse_overlap(const Packing& packing, double spacing, double displacement, double largest_radius) {
  constexpr std::size_t max_per_body = 1000;
  const double tolerance = rounding_depth(*packing.bounds);
  double worst_ratio = 1.0;
  std::optional<ClosePair> deepest;
  double deepest_depth = tolerance;
  std::size_t left = max_per_body * packing.bodies.size();
  visit_close_pairs(packing, [&](const ClosePair& pair) {
    const double needed = packing.bodies[pair.first].radius + packing.bodies[pair.second].radius;
    worst_ratio = std::max(worst_ratio, needed / pair.distance);
    const double depth = needed - pair.distance;
    if (depth > deepest_depth || (deepest && depth == deepest_depth && pair < *deepest)) {
      deepest = pair;
      deepest_depth = depth;
    }
    return --left > 0;
  });
  if (!deepest) return;
  const bool exact = displacement == 0.0 && left > 0;
  const double always_enough = 2.0 * largest_radius + 2.0 * displacement;
  fail_overlap(packing, *deepest, exact ? std::min(worst_ratio * spacing, always_enough) : always_enough);
}

}  // namespace

LatticeKind lattice_kind(std::string_view name) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return LatticeKind(k);
  throw Error("lattice", fmt::format("unknown kind {}", files::quote_token(name)),
              files::suggest_name(name, names));
}

std::string_view lattice_name(LatticeKind kind) { return names[std::size_t(kind)]; }

int lattice_dimension(LatticeKind kind) {
  return kind == LatticeKind::square || kind == LatticeKind::triangular ? 2 : 3;
}

Packing fill_lattice(const LatticeOptions& options, const RadiusDistribution& distribution, Random& random) {
  require_length(options.gap, "gap");
  require_length(options.displacement, "displacement");
  const SiteCount count = resolve_count(options);
  const std::int64_t sites = require_count(count, options.kind);
  require_closure(options, count);
  const auto bodies = std::size_t(options.total.value_or(sites));
  const std::vector<double> radii = draw_radii(distribution, bodies, random);
  const double largest_radius = *std::max_element(radii.begin(), radii.end());
  const double spacing = resolve_spacing(options, largest_radius);
  const Box box = resolve_box(options, count, spacing, largest_radius);
  Packing packing;
  packing.dimension = lattice_dimension(options.kind);
  packing.bounds = box.bounds;
  packing.periodic = options.periodic;
  packing.bodies.reserve(bodies);
  place_bodies(packing, options, count, box, spacing, radii, random);
  check(packing);
  refuse_overlap(packing, spacing, options.displacement, largest_radius);
  return packing;
}

}  // namespace scree::packing
