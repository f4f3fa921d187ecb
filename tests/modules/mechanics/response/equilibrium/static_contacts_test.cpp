#include "increment.hpp"

#include <catch2/catch.hpp>

#include <scree/wall_surfaces.hpp>

namespace scree::test {

namespace {

// Histories, and forces, after the same motion.
void check_step(Increment& increment, bool search) {
  auto& [s, freedom, contacts, motion, after, loads] = increment;
  const Particles& p = s.particles();
  const int dimension = s.dimension();
  increment.evaluate(motion);
  contacts.commit();
  if (search) contacts.find_pairs(after, 0.3);  // which keeps what is known
  s.step();

  const ContactList list = s.contact_list();
  const std::vector<ContactHistory> touching = contacts.touching();
  REQUIRE(touching.size() == list.size());
  for (const ContactHistory& pair : touching) {
    std::size_t c = 0;
    while (c < list.size() && (list.a[c] != pair.a || list.b[c] != pair.b)) ++c;
    REQUIRE(c < list.size());
    for (std::uint32_t k = 0; k < pair.numbers.size(); ++k)
      CHECK(pair.numbers[k] == Approx(s.contact_history(list.pair[c], k)).margin(1e-13));
  }
  const auto equals = [](double x) { return Approx(x).epsilon(1e-10).margin(1e-8); };
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < dimension; ++k) CHECK(loads.force[i][k] == equals(p.force()[k][i]));
  const std::size_t walls = p.size() + s.planes().size();
  for (std::size_t i = 0; i < s.surfaces().size(); ++i)
    for (int k = 0; k < 3; ++k) {
      CHECK(loads.force[walls + i][k] == equals(s.surfaces().loads[i].force[k]));
      CHECK(loads.torque[walls + i][k] == equals(s.surfaces().loads[i].torque[k]));
    }
}

// All but the first begin with springs.
void check_steps(const Scene& scene) {
  Increment increment(scene);
  for (const bool search : {true, false, false}) check_step(increment, search);
}

}  // namespace

// The kernel's step with the same motion, without dashpots: the same springs, whichever moves the pairs.
TEST_CASE("an increment changes springs as a step of the kernel does") {
  const Values springs = {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e3}},
                          {"tangential_damping", {0}},
                          {"static_friction", {0.5}}};
  for (const int dimension : {2, 3}) {
    INFO(dimension << " dimensions");
    check_steps(moving_heap(dimension, "linear_spring_dashpot", springs));
    check_steps(moving_beds(dimension, "linear_spring_dashpot", springs));
  }
  check_steps(moving_heap(3, "sphere_path_independent", springs));
  check_steps(moving_beds(3, "sphere_path_independent", springs));
  const double outside = 0.35;  // of the period, into which it is folded
  check_steps(with_motions(periodic_trough(springs, "sphere_path_independent", outside)));
  check_steps(moving_heap(2, "disc_corrected",
                          {{"normal_stiffness", {1e4}},
                           {"normal_damping", {0}},
                           {"tangential_stiffness", {1e3}},
                           {"friction", {0.5}}}));
  const Values hertz_values = {
      {"youngs_modulus", {1e5}}, {"poissons_ratio", {0.25}}, {"restitution", {1}}, {"friction", {0.5}}};
  check_steps(moving_heap(3, "hertz_mindlin", hertz_values));
  check_steps(moving_beds(3, "hertz_mindlin", hertz_values));
}

}  // namespace scree::test
