#include "static_contacts.hpp"

#include "packings.hpp"

#include <catch2/catch.hpp>

namespace scree::test {

namespace {

using namespace response;

constexpr double share = 0.02;  // of a radius, by which bodies move in a step

// A heap whose bodies move by themselves, and one that first touches it in the middle of the step.
Scene moving_heap(int dimension, const std::string& plugin, const Values& law) {
  Scene s = heap(dimension, law, plugin);
  const Vec3 last = s.bodies.back().position;
  const double gap = 0.5 * share;
  s.bodies.push_back(
      body(9, 1, heavy, last + Vec3{{s.bodies.back().radius + 1 + gap, 0, 0}}, {}, {}, dimension));
  for (std::size_t i = 0; i < s.bodies.size(); ++i)
    for (int k = 0; k < (dimension == 2 ? 3 : 6); ++k)
      motion(s.bodies[i], dimension, k) = share * std::sin(1.0 + 2.3 * double(i) + 1.7 * k) / s.step;
  s.bodies.back().velocity = s.bodies[s.bodies.size() - 2].velocity - Vec3{{2 * gap / s.step, 0, 0}};
  return s;
}

// The bodies of a scene and the motion of a step, as a quasi-static increment.
struct Increment {
  Simulation simulation;
  DegreesOfFreedom freedom;
  StaticContacts contacts;
  Eigen::VectorXd motion;
  StaticConfiguration after;
  StaticLoads loads;

  explicit Increment(const Scene& scene)
      : simulation(scene),
        freedom(scene.dimension, spins(), everybody(), everybody(), {false}),
        contacts(simulation, spins()),
        motion(freedom.size()),
        after(simulation) {
    contacts.find_pairs(after, 0.2);
    for (std::size_t i = 0; i < freedom.bodies(); ++i) {
      for (int k = 0; k < scene.dimension; ++k)
        motion[freedom.translation(i, k)] = scene.step * scene.bodies[i].velocity[k];
      for (int k = 0; k < spins(); ++k)
        motion[freedom.rotation(i, k)] = scene.step * scene.bodies[i].spin[scene.dimension == 2 ? 2 : k];
    }
  }

  int spins() const {
    return simulation.particles().spin_axes().last - simulation.particles().spin_axes().first;
  }
  std::vector<bool> everybody() const { return std::vector<bool>(simulation.particles().size(), true); }

  void evaluate(const Eigen::VectorXd& moved) {
    const StaticMotion all(moved, freedom, simulation.linear_walls());
    after = StaticConfiguration(simulation);
    after.move(all);
    const std::size_t ends = after.position.size();
    loads = {std::vector<Vec3>(ends), std::vector<Vec3>(ends)};
    contacts.evaluate(after, all, loads);
  }
};

// Largest difference of histories, and of forces, over the largest of each, after the same motion.
void check_step(const Scene& scene) {
  Increment increment(scene);
  auto& [s, freedom, contacts, motion, after, loads] = increment;
  const Particles& p = s.particles();
  increment.evaluate(motion);
  contacts.commit();
  contacts.find_pairs(after, 0.3);  // which keeps what is known
  s.step();

  const ContactList list = s.contact_list();
  const std::vector<TouchingPair> touching = contacts.touching();
  REQUIRE(touching.size() == list.size());
  for (const TouchingPair& pair : touching) {
    std::size_t c = 0;
    while (c < list.size() && (list.a[c] != pair.a || list.b[c] != pair.b)) ++c;
    REQUIRE(c < list.size());
    for (std::uint32_t k = 0; k < pair.width; ++k)
      CHECK(pair.history[k] == Approx(s.contact_history(list.pair[c], k)).margin(1e-13));
  }
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < scene.dimension; ++k)
      CHECK(loads.force[i][k] == Approx(p.force()[k][i]).epsilon(1e-10).margin(1e-8));
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
    check_step(moving_heap(dimension, "linear_spring_dashpot", springs));
  }
  check_step(moving_heap(3, "sphere_path_independent", springs));
  check_step(moving_heap(2, "disc_corrected",
                         {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e3}},
                          {"friction", {0.5}}}));
  check_step(moving_heap(
      3, "hertz_mindlin",
      {{"youngs_modulus", {1e5}}, {"poissons_ratio", {0.25}}, {"restitution", {1}}, {"friction", {0.5}}}));
}

// The last body first touches in the middle of the increment: its spring takes the part of the slip since then, which grows with the overlap.
TEST_CASE("the stiffness of a contact that begins to touch is the derivative of its force") {
  const Values springs = {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e4}},
                          {"tangential_damping", {0}},
                          {"static_friction", {1e3}}};
  for (const int dimension : {2, 3}) {
    INFO(dimension << " dimensions");
    Increment increment(moving_heap(dimension, "linear_spring_dashpot", springs));
    const auto last = std::uint32_t(increment.freedom.bodies() - 1);
    Entries entries(increment.freedom, WallEquations{});
    increment.evaluate(increment.motion);
    increment.contacts.add_stiffness(entries);
    const Eigen::MatrixXd stiffness = entries.of_motions();
    const auto number = [&](int k) {
      return k < dimension ? increment.freedom.translation(last, k)
                           : increment.freedom.rotation(last, k - dimension);
    };
    for (int c = 0; c < dimension + increment.spins(); ++c) {
      const double change = 1e-6;
      std::vector<Vec3> forces;
      for (const double sign : {1.0, -1.0}) {
        increment.evaluate(increment.motion +
                           sign * change * Eigen::VectorXd::Unit(increment.motion.size(), number(c)));
        forces.push_back(increment.loads.force[last]);
      }
      for (int k = 0; k < dimension; ++k) {
        INFO("force " << k << " by motion " << c);
        // Normals in the middle of the increment count as those at its end: the motion over the radius, at most 0.05, of 1e4 N/m.
        CHECK(stiffness(number(k), number(c)) ==
              Approx(-(forces[0][k] - forces[1][k]) / (2 * change)).margin(0.05 * 1e4));
      }
    }
  }
}

}  // namespace scree::test
