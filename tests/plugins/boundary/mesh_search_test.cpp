#include "meshes.hpp"
#include "wall_support.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/state.hpp>

// What searches remember of bodies near meshes changes no bit: a run that goes on from a state remembers
// nothing.

using namespace scree;
using namespace scree::test;

namespace {

// Spheres that fly about in a turning box of fine triangles, along its faces, into its edges and corners, and
// through the middle.
Scene spheres_in_box() {
  std::vector<Body> bodies;
  for (std::int64_t k = 0; k < 27; ++k) {
    const Vec3 place = {
        {0.5 * double(k % 3) - 0.5, 0.5 * double(k / 3 % 3) - 0.5, 0.5 * double(k / 9) - 0.5}};
    const double a = 2.4 * double(k);
    bodies.push_back(body(k, 0.1 + 0.002 * double(k % 5), 1, place,
                          {{2 * std::cos(a), 2 * std::sin(a), 1.5 * std::sin(3 * a)}}));
  }
  Scene s = scene(3, 5e-4, bodies,
                  {{"normal_stiffness", {8000}},
                   {"restitution", {0.95}},
                   {"tangential_stiffness", {3000}},
                   {"static_friction", {0.2}}});
  add_boundary(
      s, "mesh",
      {{"file", box_mesh({{0.8, 0.8, 0.8}}, 16).numbers()}, {"spin", {0.3}}, {"spin_axis", {0, 0, 1}}},
      "box");
  s.skin = 0.002;  // below the overlaps, so that bodies slide on by more than the skin
  add_body_force(s, "gravity", {{"acceleration", {1, -3, -6}}});
  return s;
}

}  // namespace

TEST_CASE("searches near meshes find the same without what they remember", "[surfaces]") {
  const Scene sc = spheres_in_box();
  Simulation s(sc);
  for (int k = 0; k < 60; ++k) {
    Simulation again(sc, s.state());
    run(s, 40), run(again, 40);
    INFO("after " << 40 * (k + 1) << " steps");
    REQUIRE(again.state_hash() == s.state_hash());
    REQUIRE(again.footprint().listed_pairs == s.footprint().listed_pairs);
  }
}
