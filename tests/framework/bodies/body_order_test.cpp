#include "bodies/body_range.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/body_order.hpp>

using scree::BodyOrder;
using scree::Particles;

TEST_CASE("places and numbers of rearranged bodies belong to each other", "[order]") {
  std::vector<std::uint32_t> from(100);
  std::iota(from.begin(), from.end(), 0u);
  CHECK(!BodyOrder(from).rearranged());
  CHECK(BodyOrder().number(7) == 7);
  CHECK(BodyOrder().place(7) == 7);
  std::mt19937 generator(1);
  std::shuffle(from.begin(), from.end(), generator);
  const BodyOrder once = BodyOrder().moved(from), twice = once.moved(from);
  REQUIRE(once.rearranged());
  for (std::uint32_t place = 0; place < from.size(); ++place) {
    CHECK(once.number(place) == from[place]);
    CHECK(once.place(from[place]) == place);
    CHECK(twice.number(place) == from[from[place]]);
  }
  CHECK(!twice.moved(twice.back()).rearranged());
}

TEST_CASE("a rearranged body takes all that it has to its new place, and back", "[order]") {
  const int dimension = GENERATE(2, 3);
  std::vector<scree::Body> bodies;
  for (int i = 0; i < 5; ++i) {
    const double x = i;
    bodies.push_back(scree::test::body(10 - i, 1 + x, 2 + x, {{x, 2 * x, dimension == 3 ? x : 0}},
                                       {{-x, x, 0}}, {{0, 0, 3 * x}}, dimension));
    bodies.back().material = std::uint32_t(i % 2);
    bodies.back().fixed = i == 3;
    bodies.back().held = i == 4 ? 1 : 0;
  }
  Particles p(dimension, {.spin = true, .images = true, .orientations = true}, bodies);
  for (std::size_t i = 0; i < 5; ++i) p.image[0][i] = int(i), p.force()[1][i] = 7.0 * double(i);
  p.orientations.rotate(std::as_const(p).spin(), 0.1, 0, 5);
  const Particles before = p;
  const std::vector<std::uint32_t> from = {3, 1, 4, 0, 2};
  p.set_load_rows(9);
  p.rearrange(from, std::vector<scree::BodyRange>{{0, 5}});
  const auto check_moved = [&](const Particles& now, const auto& old_place) {
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t j = old_place(i);
      const scree::Body a = now.body(i), b = before.body(j);
      CHECK((a.id == b.id && a.material == b.material && a.radius == b.radius && a.mass == b.mass &&
             a.inertia == b.inertia && a.position == b.position && a.velocity == b.velocity &&
             a.spin == b.spin && a.fixed == b.fixed && a.held == b.held));
      CHECK(now.image[0][i] == before.image[0][j]);
      CHECK(now.force()[1][i] == before.force()[1][j]);
      CHECK(now.orientations[0][i] == before.orientations[0][j]);
      CHECK(now.inverse_mass()[i] == before.inverse_mass()[j]);
    }
  };
  check_moved(p, [&](std::size_t i) { return from[i]; });
  Particles copy = p;
  p.copy_in_scene_order(copy);
  check_moved(copy, [](std::size_t i) { return i; });
}
