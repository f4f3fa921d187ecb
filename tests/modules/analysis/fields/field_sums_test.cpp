#include "field_scenes.hpp"
#include "numbers.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/fields/field_sums.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

ThreadPool& one_thread() {
  static ThreadPool pool(1);
  return pool;
}

std::vector<FieldPoint> fields_of(const FieldInput& input, const FieldGrid& grid,
                                  const AveragingKernel& kernel) {
  FieldSums sums(grid, kernel);
  sums.add(input, one_thread());
  return sums.means();
}

void check_near(const Vec3& a, const Vec3& b, double margin) {
  for (int k = 0; k < 3; ++k) CHECK(a[k] == Approx(b[k]).margin(margin));
}

}  // namespace

TEST_CASE("integrals over space are sums over bodies and contacts, at every width", "[fields]") {
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    const FieldInput input = input_of(*simulation);
    double mass = 0;
    Tensor love_weber = {};
    for (const FieldBody& b : input.bodies) mass += b.mass;
    for (const FieldContact& c : input.contacts)
      for (int i = 0; i < 9; ++i) love_weber[std::size_t(i)] += c.force[i / 3] * c.line[i % 3];
    for (const double w : {1.6, 2.2, 3.0}) {
      const FieldGrid grid = grid_over(packing, 0.4);
      double mass_in_grid = 0;
      Tensor stress = {};
      for (const FieldPoint& p : fields_of(input, grid, AveragingKernel(packing.dimension, w))) {
        mass_in_grid += p.density * grid.cell();
        for (std::size_t c = 0; c < 9; ++c) stress[c] += p.contact_stress[c] * grid.cell();
      }
      // A sum over cells of a quarter of the width or less.
      CHECK(mass_in_grid == Approx(mass).epsilon(1e-4));
      for (std::size_t c = 0; c < 9; ++c)
        CHECK(stress[c] == Approx(love_weber[c]).margin(1e-4 * std::abs(love_weber[0])));
    }
  }
}

TEST_CASE("forces balance at every point, at walls and periodic faces too", "[fields]") {
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    simulation->apply_reconfiguration();  // drag at the velocities of this time
    const FieldInput input = input_of(*simulation);
    for (const double w : {1.2, 2.5}) {
      const std::vector<FieldPoint> points =
          fields_of(input, grid_over(packing), AveragingKernel(packing.dimension, w));
      double traction = 0, divergence = 0;
      for (const FieldPoint& p : points) {
        traction = std::max(traction, norm(p.traction));
        divergence = std::max(divergence, norm(p.stress_divergence));
      }
      CHECK(divergence > 1);
      if (int(packing.periodic.size()) < packing.dimension) CHECK(traction > 1);
      INFO(fmt::format("relative {:g}", force_residual(points)));
      CHECK(force_residual(points) < 1e-13);
    }
  }
}

TEST_CASE("a force that is not counted shows in the balance of forces", "[fields]") {
  const PackingScene packing = packing_scenes[0];
  const FieldInput input = input_of(*agitated(packing));
  const auto residual = [&](const FieldInput& changed) {
    return force_residual(fields_of(changed, grid_over(packing), AveragingKernel(3, 2)));
  };
  for (const bool wall : {false, true}) {
    FieldInput changed = input;
    // The weakest one of its kind.
    std::size_t weakest = input.contacts.size();
    for (std::size_t c = 0; c < input.contacts.size(); ++c)
      if ((input.contacts[c].b == FieldContact::wall) == wall &&
          (weakest == input.contacts.size() ||
           norm(input.contacts[c].force) < norm(input.contacts[weakest].force)))
        weakest = c;
    changed.contacts.erase(changed.contacts.begin() + std::ptrdiff_t(weakest));
    CHECK(residual(changed) > 1e-5);
  }
  FieldInput changed = input;
  changed.bodies[7].body_force = {};
  CHECK(residual(changed) > 1e-4);
}

TEST_CASE("holding forces are opposite to the loads of held components", "[fields]") {
  const PackingScene packing = {"", 2, {}, true};
  FieldInput input = input_of(*agitated(packing));
  const FieldGrid grid = grid_over(packing, 0.4);
  Vec3 sum = {}, expected = {};
  for (const FieldPoint& p : fields_of(input, grid, AveragingKernel(2, 2)))
    sum += grid.cell() * p.holding_force;
  for (const FieldBody& b : input.bodies)
    for (int k = 0; k < 2; ++k)
      if (b.is_held(k)) expected[k] -= b.force[k];
  CHECK(norm(expected) > 1);
  check_near(sum, expected, 1e-4 * norm(expected));
}

TEST_CASE("a fast drift costs the kinetic stress no digits", "[fields]") {
  const PackingScene packing = packing_scenes[0];
  FieldInput input = input_of(*agitated(packing));
  const FieldGrid grid = grid_over(packing);
  const std::vector<FieldPoint> rest = fields_of(input, grid, AveragingKernel(3, 2));
  const double drift = 1e6;
  for (FieldBody& b : input.bodies) b.velocity[0] += drift;
  const std::vector<FieldPoint> moving = fields_of(input, grid, AveragingKernel(3, 2));
  for (std::size_t k = 0; k < rest.size(); ++k)
    for (std::size_t c = 0; c < 9; ++c)
      // Velocities lose 1e6 ε; ρ V² - p²/ρ would lose 1e12 ε.
      CHECK(moving[k].kinetic_stress[c] == Approx(rest[k].kinetic_stress[c]).margin(1e-8));
}

TEST_CASE("the mean of states has the kinetic stress about the mean of all", "[fields]") {
  const PackingScene packing = packing_scenes[1];
  const auto simulation = agitated(packing);
  const FieldInput first = input_of(*simulation);
  run(*simulation, 100);
  const FieldInput second = input_of(*simulation);
  const FieldGrid grid = grid_over(packing);
  const AveragingKernel kernel(2, 2);
  FieldSums sums(grid, kernel);
  sums.add(first, one_thread());
  sums.add(second, one_thread());
  const std::vector<FieldPoint> mean = sums.means(), a = fields_of(first, grid, kernel),
                                b = fields_of(second, grid, kernel);
  CHECK(sums.mean_time() == Approx(0.5 * (first.time + second.time)));
  for (std::size_t k = 0; k < mean.size(); ++k) {
    CHECK(mean[k].density == Approx(0.5 * (a[k].density + b[k].density)).margin(1e-13));
    CHECK(mean[k].contact_stress[1] ==
          Approx(0.5 * (a[k].contact_stress[1] + b[k].contact_stress[1])).margin(1e-11));
    if (!(mean[k].density > 1e-6)) continue;
    double spread = 0;
    for (const FieldPoint* p : {&a[k], &b[k]}) {
      const Vec3 off = p->velocity - mean[k].velocity;
      spread += 0.5 * (p->kinetic_stress[0] + p->density * off[0] * off[0]);
    }
    CHECK(mean[k].kinetic_stress[0] == Approx(spread).margin(1e-12));
  }
}

TEST_CASE("shear within the width of the kernel adds to the kinetic stress", "[fields]") {
  // Grains on a lattice with v_x = γ̇ y, at w/12: ⟨y²⟩ of the kernel is w²/11 in 3D, w²/10 in 2D.
  const double rate = 3, width = 0.6;
  for (const int dimension : {2, 3}) {
    FieldInput input = {.dimension = dimension};
    const int reach = dimension == 3 ? 12 : 0;
    for (int x = -12; x <= 12; ++x)
      for (int y = -12; y <= 12; ++y)
        for (int z = -reach; z <= reach; ++z) {
          const Vec3 at = {x * width / 12, y * width / 12, z * width / 12};
          input.bodies.push_back(
              {.mass = 2, .radius = 0.01, .position = at, .velocity = {rate * at[1], 0, 0}});
        }
    const FieldGrid grid = {.dimension = dimension};
    const FieldPoint point = fields_of(input, grid, AveragingKernel(dimension, width)).front();
    // The sum over the lattice: the kernel falls as the cube at its edge, an error of some (1/12)^4.
    CHECK(point.kinetic_stress[0] / point.density ==
          Approx(rate * rate * width * width / (dimension == 3 ? 11 : 10)).epsilon(1e-4));
  }
}

TEST_CASE("fields have the same bits for any number of threads", "[fields]") {
  for (const std::size_t scene : {std::size_t(0), std::size_t(3)}) {
    const PackingScene& packing = packing_scenes[scene];
    const FieldInput input = input_of(*agitated(packing));
    const FieldGrid grid = grid_over(packing);
    const AveragingKernel kernel(packing.dimension, 2);
    const std::vector<FieldPoint> one = fields_of(input, grid, kernel);
    for (const unsigned threads : {2u, 5u}) {
      ThreadPool pool(threads);
      FieldSums sums(grid, kernel);
      sums.add(input, pool);
      const std::vector<FieldPoint> many = sums.means();
      bool same = true;
      for (std::size_t k = 0; k < one.size(); ++k)
        same &= one[k].contact_stress == many[k].contact_stress &&
                one[k].kinetic_stress == many[k].kinetic_stress && one[k].density == many[k].density &&
                one[k].residual() == many[k].residual() && one[k].largest_term == many[k].largest_term &&
                one[k].traction == many[k].traction;
      CHECK(same);
    }
  }
}

TEST_CASE("inputs that do not fit the grid are refused", "[fields]") {
  const FieldInput input = input_of(*agitated(packing_scenes[0], 1));
  const auto refused = [&](const PackingScene& other) {
    FieldSums sums(grid_over(other), AveragingKernel(other.dimension, 1));
    try {
      sums.add(input, one_thread());
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused(packing_scenes[1]) == "the states have scenes in 2D and in 3D; give states of one run");
  CHECK(refused(packing_scenes[2]) == "the states have different periodic lengths; give states of one run");
}
