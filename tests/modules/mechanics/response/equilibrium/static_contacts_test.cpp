#include "equilibrium/static_contacts.hpp"

#include "../packings.hpp"

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
  const std::vector<ContactHistory> touching = contacts.touching();
  REQUIRE(touching.size() == list.size());
  for (const ContactHistory& pair : touching) {
    std::size_t c = 0;
    while (c < list.size() && (list.a[c] != pair.a || list.b[c] != pair.b)) ++c;
    REQUIRE(c < list.size());
    for (std::uint32_t k = 0; k < pair.numbers.size(); ++k)
      CHECK(pair.numbers[k] == Approx(s.contact_history(list.pair[c], k)).margin(1e-13));
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
TEST_CASE("the stiffness after an increment is the derivative of its forces") {
  const bool slides = GENERATE(true, false);
  const Values springs = {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e4}},
                          {"tangential_damping", {0}},
                          {"static_friction", {slides ? 0.1 : 1e3}}};
  for (const int dimension : {2, 3}) {
    INFO(dimension << " dimensions");
    Increment increment(moving_heap(dimension, "linear_spring_dashpot", springs));
    const DegreesOfFreedom& freedom = increment.freedom;
    Entries entries(freedom, WallEquations{});
    increment.evaluate(increment.motion);
    increment.contacts.add_stiffness(entries);
    const Eigen::MatrixXd stiffness = entries.of_motions();
    const auto forces_at = [&](const Eigen::VectorXd& motion) {
      increment.evaluate(motion);
      Eigen::VectorXd all(freedom.size());
      for (std::size_t i = 0; i < freedom.bodies(); ++i) {
        for (int k = 0; k < dimension; ++k) all[freedom.translation(i, k)] = increment.loads.force[i][k];
        for (int k = 0; k < increment.spins(); ++k)
          all[freedom.rotation(i, k)] = increment.loads.torque[i][dimension == 2 ? 2 : k];
      }
      return all;
    };
    constexpr double change = 1e-6;
    Eigen::MatrixXd difference(freedom.size(), freedom.size());
    for (Eigen::Index c = 0; c < freedom.size(); ++c) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(freedom.size(), c);
      difference.col(c) =
          (forces_at(increment.motion - change * unit) - forces_at(increment.motion + change * unit)) /
          (2 * change);
    }
    // Round-off of 1e3 N over the change: 1e-7 N/m; third derivatives: the square of the change over the motion, 2e-2. In 3D the velocity by which
    // laws turn the direction of slip counts with the normal at rest: the motion over the radius.
    const double tolerance = dimension == 3 && slides ? share : 1e-6;
    CHECK((stiffness - difference).cwiseAbs().maxCoeff() < tolerance * difference.cwiseAbs().maxCoeff());
  }
}

}  // namespace scree::test
