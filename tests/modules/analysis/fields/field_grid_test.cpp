#include <cmath>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include <scree/fields/field_grid.hpp>

using namespace scree;
using fields::FieldGrid;
using fields::GridSlab;

namespace {

// Offsets of all points and images that are within reach of a line's box, as each_near must find.
using Near = std::multimap<std::size_t, Vec3>;

Near near_by_brute_force(const FieldGrid& grid, const Vec3& start, const Vec3& line, double reach) {
  Near near;
  const int images = 3;
  for (std::size_t number = 0; number < grid.size(); ++number)
    for (int x = -images; x <= images; ++x)
      for (int y = -images; y <= images; ++y) {
        if ((x != 0 && grid.period[0] == 0) || (y != 0 && grid.period[1] == 0)) continue;
        const Vec3 offset = grid.point(number) + Vec3{{x * grid.period[0], y * grid.period[1], 0}} - start;
        bool inside = true;
        for (int k = 0; k < grid.dimension; ++k)
          inside &=
              offset[k] >= std::min(0.0, line[k]) - reach && offset[k] <= std::max(0.0, line[k]) + reach;
        if (inside) near.emplace(number, offset);
      }
  return near;
}

void check_same(const Near& found, const Near& expected) {
  REQUIRE(found.size() == expected.size());
  for (const auto& [number, offset] : expected) {
    const auto [first, last] = found.equal_range(number);
    int same = 0;
    for (auto at = first; at != last; ++at) same += norm(at->second - offset) < 1e-12;
    CHECK(same == 1);
  }
}

FieldGrid some_grid(int dimension) {
  FieldGrid grid;
  grid.dimension = dimension;
  grid.first = {{0.05, -0.4, dimension == 2 ? 0 : 0.3}};
  grid.spacing = {{0.1, 0.23, 0.31}};
  grid.count = {10, 4, dimension == 2 ? 1u : 3u};
  grid.period = {{1, 0.8, 0}};  // the grid covers a period along x, more than one along y
  return grid;
}

}  // namespace

TEST_CASE("each point and periodic image near a line is visited once, in one slab", "[fields]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(-1, 1);
  for (const int dimension : {2, 3})
    for (int trial = 0; trial < 40; ++trial) {
      const FieldGrid grid = some_grid(dimension);
      Vec3 start = {{part(random), part(random), part(random)}},
           line = {{part(random), 0.3 * part(random), part(random)}};
      if (dimension == 2) start[2] = line[2] = 0;
      const double reach = 0.5 + 0.4 * part(random);  // also beyond half of a period
      const std::size_t slabs = trial % 2 ? 1 : 3;
      Near found;
      for (std::size_t part_number = 0; part_number < slabs; ++part_number) {
        const GridSlab slab = grid.slab(part_number, slabs);
        CHECK(slab.axis == 0);
        grid.each_near(start, line, reach, slab, [&](std::size_t number, const Vec3& offset) {
          CHECK(number % grid.count[0] >= slab.begin);
          CHECK(number % grid.count[0] < slab.end);
          found.emplace(number, offset);
        });
      }
      check_same(found, near_by_brute_force(grid, start, line, reach));
    }
}
