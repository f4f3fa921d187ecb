#include "scenes.hpp"

#include <catch2/catch.hpp>

// Separations, radii and orientations as laws read them, by the spring between painted points of
// `disc_angular`.

using namespace scree;
using namespace scree::test;

namespace {

const Values painted_law = {
    {"normal_stiffness", {1}}, {"normal_damping", {0}}, {"tangential_stiffness", {1}}, {"friction", {1e9}}};

// A column of the history of the only contact.
double history(const Simulation& s, std::uint32_t column) {
  const ContactList list = s.contact_list();
  REQUIRE(list.size() == 1);
  return s.contact_history(list.pair[0], column);
}
constexpr std::uint32_t spring_column = 4, rolling_column = 5;

}  // namespace

TEST_CASE("a disc on a wall keeps its painted points across periodic faces", "[placement]") {
  // Too heavy for the contact to accelerate it: 46 N in 20 s move it by 1e-16 m. Ten periods are crossed,
  // with a spin of its own.
  constexpr double radius = 1, speed = 2, spin = 0.3, step = 1e-3;
  constexpr int steps = 20000;
  Scene s = scene(2, step, {body(1, radius, 1e20, {{0.5, 0.98, 0}}, {{speed, 0, 0}}, {{0, 0, spin}}, 2)},
                  painted_law, "disc_angular");
  add_boundary(s, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {4, 4, 0}}});
  add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  Simulation simulation(s);
  run(simulation, steps);
  // The wall's t = z × n is −x. From the first evaluation, at t = 0: along x by v t, and R ω t by the spin.
  const double travelled = speed * step * steps, turned = spin * step * steps;
  CHECK(history(simulation, spring_column) == Approx(-travelled - radius * turned).epsilon(1e-12));
  CHECK(history(simulation, rolling_column) == Approx(0.5 * (travelled - radius * turned)).epsilon(1e-12));
}

TEST_CASE("a pair keeps its painted points across periodic faces", "[placement]") {
  constexpr double speed = 2, spin = 0.3, step = 1e-3;
  constexpr int steps = 20000;
  Scene s = scene(2, step,
                  {body(1, 1, 1e20, {{0.5, 1, 0}}, {{speed, 0, 0}}, {{0, 0, spin}}, 2),
                   body(2, 0.5, 1e20, {{1.98, 1, 0}}, {{speed, 0, 0}}, {}, 2)},
                  painted_law, "disc_angular");
  add_boundary(s, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {8, 4, 0}}});
  Simulation simulation(s);
  run(simulation, steps);
  CHECK(history(simulation, spring_column) == Approx(-spin * step * steps).epsilon(1e-12));
}
