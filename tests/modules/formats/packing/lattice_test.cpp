#include "packing_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/packing/lattice.hpp>
#include <scree/packing/overlap.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using scree::Vec3;

namespace {

constexpr LatticeKind every_kind[] = {LatticeKind::simple_cubic, LatticeKind::face_centred_cubic,
                                      LatticeKind::hexagonal_close, LatticeKind::square,
                                      LatticeKind::triangular};

LatticeOptions options_of(LatticeKind kind, std::int64_t x, std::int64_t y, std::int64_t z) {
  LatticeOptions options;
  options.kind = kind;
  options.count = {x, y, lattice_dimension(kind) == 3 ? z : 1};
  return options;
}

Packing fill(const LatticeOptions& options, const RadiusDistribution& radii, std::uint64_t seed = 1) {
  Random random(seed);
  return fill_lattice(options, radii, random);
}

std::string refusal_of_lattice(const LatticeOptions& options,
                               const RadiusDistribution& radii = ConstantRadius{1.0}) {
  return error_of([&] { fill(options, radii); });
}

double distance(const Packing& packing, std::size_t i, std::size_t j) {
  Vec3 d = packing.bodies[j].position - packing.bodies[i].position;
  for (int k = 0; k < 3; ++k) {
    const double length = packing.bounds->upper[k] - packing.bounds->lower[k];
    if (packing.periodic[k]) d[k] -= length * std::round(d[k] / length);
  }
  return norm(d);
}

double nearest_distance(const Packing& packing) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < packing.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < packing.bodies.size(); ++j)
      nearest = std::min(nearest, distance(packing, i, j));
  }
  return nearest;
}

int coordination(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::square:
      return 4;
    case LatticeKind::simple_cubic:
    case LatticeKind::triangular:
      return 6;
    default:
      return 12;
  }
}

// Packing fraction of touching equal spheres (discs).
double closed_form_fraction(LatticeKind kind) {
  const double pi = std::numbers::pi;
  switch (kind) {
    case LatticeKind::simple_cubic:
      return pi / 6.0;
    case LatticeKind::square:
      return pi / 4.0;
    case LatticeKind::triangular:
      return pi / std::sqrt(12.0);
    default:
      return pi / std::sqrt(18.0);
  }
}

}  // namespace

TEST_CASE("a lattice has the counted sites, numbered from 1, at the spacing", "[packing]") {
  for (const LatticeKind kind : every_kind) {
    LatticeOptions options = options_of(kind, 5, 4, 3);
    options.spacing = 0.7;
    options.material = "glass";
    const Packing packing = fill(options, ConstantRadius{0.3});
    REQUIRE(packing.bodies.size() == (lattice_dimension(kind) == 3 ? 60 : 20));
    CHECK(packing.dimension == lattice_dimension(kind));
    CHECK(packing.bodies.front().id == 1);
    CHECK(packing.bodies.back().id == std::int64_t(packing.bodies.size()));
    CHECK(packing.bodies.back().material == "glass");
    // Coordinates below 4 m are rounded a few times each.
    CHECK(std::abs(nearest_distance(packing) - 0.7) < 1e-14);
  }
}

TEST_CASE("a periodic lattice of touching spheres has its closed-form density and neighbours", "[packing]") {
  for (const LatticeKind kind : every_kind) {
    LatticeOptions options = options_of(kind, 6, 6, 6);
    options.periodic = {true, true, lattice_dimension(kind) == 3};
    const Packing packing = fill(options, ConstantRadius{0.5});
    const Vec3 length = packing.bounds->upper - packing.bounds->lower;
    const bool spatial = packing.dimension == 3;
    const double box = length[0] * length[1] * (spatial ? length[2] : 1.0);
    const double body = spatial ? std::numbers::pi / 6.0 : std::numbers::pi / 4.0;
    const double fraction = double(packing.bodies.size()) * body / box;
    CHECK(std::abs(fraction - closed_form_fraction(kind)) < 1e-14);
    for (std::size_t i = 0; i < packing.bodies.size(); ++i) {
      int touching = 0;
      for (std::size_t j = 0; j < packing.bodies.size(); ++j) {
        touching += j != i && std::abs(distance(packing, i, j) - 1.0) < 1e-13;
      }
      REQUIRE(touching == coordination(kind));
    }
  }
}

TEST_CASE("bodies lie within the box, wherever it is put", "[packing]") {
  const bool centred = GENERATE(false, true);
  for (const LatticeKind kind : every_kind) {
    LatticeOptions options = options_of(kind, 4, 3, 2);
    options.origin = {{-3.0, 5.0, lattice_dimension(kind) == 3 ? 7.0 : 0.0}};
    options.centred = centred;
    options.displacement = 0.1;
    const Packing packing = fill(options, UniformRadius{0.2, 0.5});
    const Bounds inner = enclosing_bounds(packing);
    for (int k = 0; k < packing.dimension; ++k) {
      CHECK(inner.lower[k] >= packing.bounds->lower[k]);
      CHECK(inner.upper[k] <= packing.bounds->upper[k]);
      const double anchor = options.centred ? 0.5 * (packing.bounds->lower[k] + packing.bounds->upper[k])
                                            : packing.bounds->lower[k];
      CHECK(std::abs(anchor - options.origin[k]) < 1e-14);
    }
  }
}

TEST_CASE("automatic spacing leaves room for the largest radius, the gap and the displacement", "[packing]") {
  for (const LatticeKind kind : every_kind) {
    LatticeOptions options = options_of(kind, 6, 6, 4);
    options.periodic = {true, true, lattice_dimension(kind) == 3};
    options.gap = 0.01;
    const Packing still = fill(options, ConstantRadius{0.5});
    CHECK(std::abs(nearest_distance(still) - 1.01) < 1e-14);
    options.displacement = 0.25;
    const Packing moved = fill(options, UniformRadius{0.1, 0.5});
    CHECK_FALSE(find_overlap(moved));
    CHECK(nearest_distance(moved) < nearest_distance(still) + 0.5);
  }
}

TEST_CASE("displacements reach their amplitude and do not exceed it", "[packing]") {
  LatticeOptions options = options_of(LatticeKind::simple_cubic, 10, 10, 10);
  options.spacing = 2.0;
  const Packing still = fill(options, ConstantRadius{0.5});
  options.displacement = 0.4;
  const Packing moved = fill(options, ConstantRadius{0.5});
  double farthest = 0.0;
  for (std::size_t k = 0; k < still.bodies.size(); ++k) {
    farthest = std::max(farthest, norm(moved.bodies[k].position - still.bodies[k].position));
  }
  CHECK(farthest <= 0.4 + 1e-14);
  CHECK(farthest > 0.36);  // that 1000 points miss the outer 27 % of a ball has probability 1e-137
}

TEST_CASE("a total fills the smallest near-cubic box", "[packing]") {
  const std::int64_t total = GENERATE(1, 7, 64, 1000, 1237);
  for (const LatticeKind kind : every_kind) {
    LatticeOptions options;
    options.kind = kind;
    options.total = total;
    const Packing packing = fill(options, ConstantRadius{0.5});
    CHECK(std::int64_t(packing.bodies.size()) == total);
    CHECK_FALSE(find_overlap(packing, 1e-13));
    const Vec3 length = packing.bounds->upper - packing.bounds->lower;
    const double shortest =
        packing.dimension == 3 ? std::min({length[0], length[1], length[2]}) : std::min(length[0], length[1]);
    // Rounding to whole rows changes an edge by at most half a row, the last by one, a stagger by half.
    if (total >= 64) CHECK(std::max({length[0], length[1], length[2]}) - shortest < 3.0);
  }
  LatticeOptions cube;
  cube.total = 343;
  const Packing packing = fill(cube, ConstantRadius{0.5});
  CHECK(packing.bounds->upper == Vec3{{7.0, 7.0, 7.0}});
}

TEST_CASE("an overlapping lattice is refused, and the spacing in the message suffices", "[packing]") {
  LatticeOptions options = options_of(LatticeKind::face_centred_cubic, 4, 4, 4);
  options.spacing = 0.9;
  const std::string message = refusal_of_lattice(options, ConstantRadius{0.5});
  CHECK_THAT(message, Contains("bodies ") && Contains("overlap by 0.1 m") && Contains("at least 1 m"));
  options.spacing = 1.0;
  CHECK(refusal_of_lattice(options, ConstantRadius{0.5}).empty());
}

TEST_CASE("the minimum spacing depends on which bodies are neighbours", "[packing]") {
  LatticeOptions options = options_of(LatticeKind::square, 4, 1, 1);
  options.spacing = 1.0;
  // Large bodies are two sites apart: 0.9 + 0.3 = 1.2 between neighbours, 1.8/2 = 0.9 between large ones.
  const ListedRadius radii{{0.9, 0.3, 0.9, 0.3}, {}};
  const std::string message = refusal_of_lattice(options, radii);
  CHECK_THAT(message, Contains("overlap by 0.2 m") && Contains("at least 1.2 m"));
  options.spacing = 1.2;
  CHECK(refusal_of_lattice(options, radii).empty());
  options.spacing = 1.199;
  CHECK_FALSE(refusal_of_lattice(options, radii).empty());
}

TEST_CASE("with displacement the message gives a spacing that always suffices", "[packing]") {
  LatticeOptions options = options_of(LatticeKind::simple_cubic, 5, 5, 5);
  options.spacing = 1.05;
  options.displacement = 0.2;
  CHECK_THAT(refusal_of_lattice(options, ConstantRadius{0.5}), Contains("at least 1.4 m"));
  options.spacing = 1.4;
  CHECK(refusal_of_lattice(options, ConstantRadius{0.5}).empty());
}

TEST_CASE("the same seed fills the same lattice", "[packing]") {
  LatticeOptions options = options_of(LatticeKind::hexagonal_close, 4, 4, 4);
  options.displacement = 0.1;
  const RadiusDistribution radii = UniformRadius{0.1, 0.2};
  CHECK(same_bits(fill(options, radii, 4), fill(options, radii, 4)));
  CHECK_FALSE(same_bits(fill(options, radii, 4), fill(options, radii, 5)));
}

TEST_CASE("invalid lattices are refused with a cure", "[packing]") {
  LatticeOptions options;
  CHECK_THAT(refusal_of_lattice(options), Contains("either the counts along the axes or the total"));
  options.total = 0;
  CHECK_THAT(refusal_of_lattice(options), Contains("give 1 to 100000000"));
  options = options_of(LatticeKind::simple_cubic, 4, 0, 4);
  CHECK_THAT(refusal_of_lattice(options), Contains("0 sites along y"));
  const std::int64_t huge = std::numeric_limits<std::int64_t>::max();
  options = options_of(LatticeKind::simple_cubic, huge, huge, huge);
  CHECK_THAT(refusal_of_lattice(options), Contains("give smaller counts"));
  options = options_of(LatticeKind::simple_cubic, 2, 2, 2);
  options.spacing = 0.0;
  CHECK_THAT(refusal_of_lattice(options), Contains("spacing 0 m"));
  options.spacing.reset();
  options.gap = -0.1;
  CHECK_THAT(refusal_of_lattice(options), Contains("gap -0.1"));
  options = options_of(LatticeKind::triangular, 4, 3, 1);
  options.periodic = {true, true, false};
  CHECK_THAT(refusal_of_lattice(options), Contains("3 rows along y") && Contains("even number"));
  options.periodic = {true, false, true};
  CHECK_THAT(refusal_of_lattice(options), Contains("cannot be periodic along z"));
  options = options_of(LatticeKind::square, 2, 2, 1);
  options.count = {2, 2, 2};
  CHECK_THAT(refusal_of_lattice(options), Contains("give 1"));
}

TEST_CASE("lattice names read back, and an unknown one suggests the nearest", "[packing]") {
  for (const LatticeKind kind : every_kind) CHECK(lattice_kind(lattice_name(kind)) == kind);
  CHECK_THAT(error_of([] { lattice_kind("face_centered_cubic"); }),
             Contains("did you mean 'face_centred_cubic'?"));
  CHECK_THAT(error_of([] { lattice_kind("body"); }), Contains("known are simple_cubic, "));
}
