#include "lattice_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::packing;
using scree::Vec3;

// Lengths are in units of the distance between nearest sites; coordinates up to 5 have errors of round-off
// below 1e-15.

namespace {

constexpr LatticeKind kinds[] = {LatticeKind::simple_cubic, LatticeKind::face_centred_cubic,
                                 LatticeKind::hexagonal_close, LatticeKind::square, LatticeKind::triangular};

std::vector<Vec3> sites_of(LatticeKind kind, const SiteCount& count) {
  std::vector<Vec3> sites;
  for (std::int64_t k = 0; k < count[2]; ++k)
    for (std::int64_t j = 0; j < count[1]; ++j)
      for (std::int64_t i = 0; i < count[0]; ++i) sites.push_back(lattice_site(kind, {i, j, k}));
  return sites;
}

SiteCount planar(LatticeKind kind, SiteCount count) {
  if (lattice_dimension(kind) == 2) count[2] = 1;
  return count;
}

}  // namespace

TEST_CASE("the nearest sites of a lattice are 1 apart, as many as the lattice has", "[packing]") {
  const int neighbours[] = {6, 12, 12, 4, 6};
  for (const LatticeKind kind : kinds) {
    CAPTURE(lattice_name(kind));
    const Vec3 inside = lattice_site(
        kind, planar(kind, {2, 2, 2}) == SiteCount{2, 2, 1} ? SiteCount{2, 2, 0} : SiteCount{2, 2, 2});
    int touching = 0;
    double least = 9;
    for (const Vec3& site : sites_of(kind, planar(kind, {5, 5, 5}))) {
      const double apart = norm(site - inside);
      if (apart == 0) continue;
      least = std::min(least, apart);
      touching += apart < 1 + 1e-14;
    }
    CHECK(std::abs(least - 1) < 1e-14);
    CHECK(touching == neighbours[int(kind)]);
  }
}

TEST_CASE("the extent of a lattice is its largest coordinate, and its smallest is 0", "[packing]") {
  for (const LatticeKind kind : kinds)
    for (const SiteCount& some : {SiteCount{1, 1, 1}, {3, 1, 2}, {2, 3, 4}, {1, 4, 3}, {2, 2, 2}}) {
      const SiteCount count = planar(kind, some);
      CAPTURE(lattice_name(kind), count[0], count[1], count[2]);
      Vec3 least{{9, 9, 9}}, most{};
      for (const Vec3& site : sites_of(kind, count))
        for (int axis = 0; axis < 3; ++axis) {
          least[axis] = std::min(least[axis], site[axis]);
          most[axis] = std::max(most[axis], site[axis]);
        }
      CHECK(least == Vec3{});
      CHECK(lattice_extent(kind, count) == most);
    }
}

TEST_CASE("a lattice of a number of bodies has room for all, and no empty layer", "[packing]") {
  for (const LatticeKind kind : kinds)
    for (const bool periodic : {false, true})
      for (const std::int64_t total : {1, 2, 9, 100, 1237}) {
        CAPTURE(lattice_name(kind), periodic, total);
        const SiteCount count = nearest_count(kind, total, {periodic, periodic, periodic});
        const int last = lattice_dimension(kind) - 1;
        const bool staggered = periodic && staggered_axes(kind)[std::size_t(last)];
        const std::int64_t sites = count[0] * count[1] * count[2], layer = sites / count[std::size_t(last)];
        CHECK(sites >= total);
        CHECK(sites - (staggered ? 2 : 1) * layer < total);
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (periodic && staggered_axes(kind)[axis]) CHECK(count[axis] % 2 == 0);
      }
}
