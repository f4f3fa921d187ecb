#include "numbers.hpp"
#include "reference_step.hpp"
#include "scenes.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using scree::Body;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::epsilon;
using scree::test::ReferenceContact;
using scree::test::ReferenceLaw;
using scree::test::ReferenceStep;

namespace {

constexpr double forces_step = 1e-3, domain_edge = 10;

scree::test::Values values(const ReferenceLaw& law) {
  return {{"normal_stiffness", {law.k}},
          {"normal_damping", {law.gamma}},
          {"tangential_stiffness", {law.k_t}},
          {"tangential_damping", {law.gamma_t}},
          {"static_friction", {law.static_friction}},
          {"dynamic_friction", {law.dynamic_friction}},
          {"tension", {law.tension_cut ? 1.0 : 0.0}}};
}

class Dealer {
 public:
  Dealer(int dimension, unsigned seed) : dimension_(dimension), generator_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Vec3 vector(double size) {
    Vec3 v = {};
    for (int k = 0; k < dimension_; ++k) v[k] = between(-size, size);
    return v;
  }
  Vec3 unit() {
    for (;;)
      if (const Vec3 v = vector(1); norm(v) > 0.1 && norm(v) < 1) return (1 / norm(v)) * v;
  }
  // Slip over a few steps is far above or far below the Coulomb limit, at random.
  Body body(std::int64_t id, const Vec3& position) {
    const double radius = between(0.3, 1);
    Vec3 spin = dimension_ == 3 ? vector(3) : Vec3{{0, 0, between(-3, 3)}};
    return scree::test::body(id, radius, between(0.5, 2), position, vector(2), spin, dimension_);
  }

 private:
  int dimension_;
  std::mt19937_64 generator_;
};

// Tolerance of a force (N): every coordinate, up to `domain_edge` plus an image, has some roundings per step,
// times k; rounding of the force itself is smaller. 64 ulps for the dozen operations from position to force
// and their sum over 2 contacts, once per step.
double force_tolerance(const ReferenceLaw& law, int steps) {
  return 64 * epsilon * (steps + 1) * (law.k + law.k_t) * 2 * domain_edge;
}

void compare(const Simulation& s, const ReferenceStep& reference, const ReferenceLaw& law, int steps) {
  const double allowed = force_tolerance(law, steps), arm = 1;
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    for (int k = 0; k < s.dimension(); ++k)
      CHECK(std::abs(s.particles().force()[k][i] - reference.force[i][k]) <= allowed);
    for (int k = s.particles().spin_axes().first; k < s.particles().spin_axes().last; ++k)
      CHECK(std::abs(s.particles().torque()[k][i] - reference.torque[i][k]) <= allowed * arm);
    const Body body = s.particles().body(i);
    // Forces on masses from 0.5 kg for a step each; inertias from 0.4 × 0.5 × 0.3² kg m².
    CHECK(norm(body.velocity - reference.now[i].velocity) <=
          allowed * forces_step * (steps + 1) / 0.5 + 8 * epsilon * steps);
    if (s.particles().has_spin())
      CHECK(norm(body.spin - reference.now[i].spin) <=
            allowed * forces_step * (steps + 1) / 0.018 + 64 * epsilon * steps);
  }
}

// Runs kernel and reference side by side.
void compare_run(const Scene& scene, const std::vector<ReferenceContact>& contacts, const ReferenceLaw& law) {
  Simulation s(scene);
  ReferenceStep reference(scene.bodies, contacts, law);
  for (int k = 0; k <= 4; ++k) {
    INFO("after step " << k);
    compare(s, reference, law, k);
    s.step();
    reference.step(forces_step);
  }
}

const ReferenceLaw reference_laws[] = {
    {.k = 1e4, .gamma = 3},
    {.k = 1e4, .gamma = 40, .tension_cut = true},
    {.k = 1e4, .k_t = 3e3, .static_friction = 1e6, .dynamic_friction = 1e6},
    {.k = 1e4, .gamma = 3, .k_t = 8e3, .gamma_t = 2, .static_friction = 0.3, .dynamic_friction = 0.2},
};

// Two overlapping bodies around a point; the shallowest contacts begin within the first step.
std::vector<Body> overlapping_pair(Dealer& deal, const Vec3& centre) {
  Body a = deal.body(0, centre), b = deal.body(1, {});
  b.position = a.position - (a.radius + b.radius - deal.between(-0.002, 0.06)) * deal.unit();
  return {a, b};
}

}  // namespace

TEST_CASE("a pair's forces and torques equal the scalar reference, and are opposite to the last bit") {
  const int dimension = GENERATE(2, 3);
  const ReferenceLaw law = GENERATE(from_range(std::begin(reference_laws), std::end(reference_laws)));
  CAPTURE(dimension, law.static_friction);
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dealer deal(dimension, seed);
    const std::vector<Body> bodies = overlapping_pair(deal, deal.vector(1));
    compare_run(scree::test::scene(dimension, forces_step, bodies, values(law)), {{.a = 0, .b = 1}}, law);

    Simulation s(scree::test::scene(dimension, forces_step, bodies, values(law)));
    scree::test::run(s, 3);
    for (int k = 0; k < dimension; ++k) CHECK(s.particles().force()[k][0] == -s.particles().force()[k][1]);
    CHECK(s.momentum_residual() == 0);
  }
}

TEST_CASE("a periodic image's forces equal the scalar reference") {
  const int dimension = GENERATE(2, 3);
  const ReferenceLaw law = reference_laws[3];
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dealer deal(dimension, seed);
    // Around a corner; coordinates are wrapped into the domain as the kernel will have them.
    std::vector<Body> bodies = overlapping_pair(deal, deal.vector(0.3));
    ReferenceContact contact = {.a = 0, .b = 1};
    for (int k = 0; k < dimension; ++k)
      for (std::size_t i = 0; i < 2; ++i)
        if (bodies[i].position[k] < 0) {
          bodies[i].position[k] += domain_edge;
          contact.shift[k] += i ? -domain_edge : domain_edge;
        }
    Scene s = scree::test::scene(dimension, forces_step, bodies, values(law));
    scree::test::add_boundary(s, "periodic",
                              {{"axes", {dimension == 2 ? 3.0 : 6.0}},
                               {"lower", {0, 0, 0}},
                               {"upper", {domain_edge, domain_edge, domain_edge}}});
    compare_run(s, {contact}, law);
  }
}

TEST_CASE("a wall's forces equal the reference of a body of infinite radius and mass, and load it exactly") {
  const int dimension = GENERATE(2, 3);
  const ReferenceLaw law = GENERATE(from_range(std::begin(reference_laws), std::end(reference_laws)));
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dealer deal(dimension, seed);
    const Vec3 normal = deal.unit(), point = deal.vector(1);
    Body a = deal.body(0, {});
    // Anywhere on the plane, at a random depth.
    a.position = point + deal.vector(1);
    a.position += (a.radius - deal.between(-0.002, 0.06) - dot(a.position - point, normal)) * normal;
    Scene scene = scree::test::scene(dimension, forces_step, {a}, values(law));
    scree::test::add_boundary(
        scene, "plane",
        {{"point", {point[0], point[1], point[2]}}, {"normal", {normal[0], normal[1], normal[2]}}});
    compare_run(scene, {{.a = 0, .plane_point = point, .plane_normal = normal}}, law);

    Simulation s(scene);
    scree::test::run(s, 3);
    for (int k = 0; k < dimension; ++k) CHECK(s.loads()[0].force[k] == -s.particles().force()[k][0]);
  }
}

TEST_CASE("forces on a body between a wall and another body add up") {
  for (const int dimension : {2, 3})
    for (unsigned seed = 0; seed < 60; ++seed) {
      const ReferenceLaw law = reference_laws[3];
      Dealer deal(dimension, seed);
      std::vector<Body> bodies = overlapping_pair(deal, {});
      const Vec3 normal = {{0, 1, 0}}, point = {{0, bodies[0].position[1] - bodies[0].radius + 0.03, 0}};
      Scene scene = scree::test::scene(dimension, forces_step, bodies, values(law));
      scree::test::add_boundary(scene, "plane", {{"point", {0, point[1], 0}}, {"normal", {0, 1, 0}}});
      scene.limits.overlap_ratio = 100;  // the other body may overlap the wall
      std::vector<ReferenceContact> contacts = {{.a = 0, .b = 1}};
      for (const std::size_t i : {0u, 1u})
        contacts.push_back({.a = i, .plane_point = point, .plane_normal = normal});
      compare_run(scene, contacts, law);
    }
}

TEST_CASE("an isolated frictional cluster conserves momentum and angular momentum to round-off") {
  const int dimension = GENERATE(2, 3);
  CAPTURE(dimension);
  // A cluster that flies apart while bodies collide, roll and slide on each other.
  Dealer deal(dimension, 9);
  std::vector<Body> bodies;
  const int per_axis = dimension == 2 ? 8 : 4, steps = 3000;
  for (int i = 0; i < std::pow(per_axis, dimension); ++i) {
    Vec3 x = {};
    for (int k = 0, rest = i; k < dimension; ++k, rest /= per_axis)
      x[k] = 1.6 * (rest % per_axis - 0.5 * per_axis);
    Body b = deal.body(i, x + deal.vector(0.1));
    b.velocity = b.velocity - 1.5 * x;  // towards the centre
    bodies.push_back(b);
  }
  ReferenceLaw law = reference_laws[3];
  law.k = 2e4;
  Simulation s(scree::test::scene(dimension, forces_step, bodies, values(law)));
  const Vec3 momentum = scree::test::momentum(s), angular = scree::test::angular_momentum(s);
  double exchanged = 0, moment = 0, size = 0, spin_size = 0;
  for (int k = 0; k < steps; ++k) {
    s.step();
    size = spin_size = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Body b = s.particles().body(i);
      double force = 0;
      for (int axis = 0; axis < dimension; ++axis) force += std::abs(s.particles().force()[axis][i]);
      exchanged += forces_step * force;
      moment += forces_step * force * (norm(b.position) + b.radius);
      size += b.mass * norm(b.velocity);
      spin_size += b.mass * norm(b.velocity) * norm(b.position) + b.inertia * norm(b.spin);
    }
  }
  // Per step each sum is rounded to an ulp of itself a few times, and each impulse to some of its own; the
  // contact point of a pair is known to an ulp of its bodies' positions. 16 covers the operations, the bound
  // is linear.
  const double allowed = 16 * epsilon * (exchanged + steps * size);
  const double allowed_angular = 16 * epsilon * (moment + steps * spin_size);
  REQUIRE(exchanged > 2 * size);  // the bodies did collide
  CHECK(norm(scree::test::momentum(s) - momentum) <= allowed);
  CHECK(norm(scree::test::angular_momentum(s) - angular) <= allowed_angular);
}
