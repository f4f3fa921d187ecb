#include "field_scenes.hpp"
#include "numbers.hpp"

#include <numbers>

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

FieldGrid at_point(const FieldGrid& like, const Vec3& place) {
  FieldGrid grid = like;
  grid.first = place;
  grid.count = {1, 1, 1};
  return grid;
}

// Calls use(x + image) for the point and its images around the scene.
template <class Use>
void each_image_of(const Vec3& x, const FieldInput& input, const Use& use) {
  const auto reach = [&](int k) { return input.domain.periodic[std::size_t(k)] ? 2 : 0; };
  for (int a = -reach(0); a <= reach(0); ++a)
    for (int b = -reach(1); b <= reach(1); ++b)
      for (int c = -reach(2); c <= reach(2); ++c) {
        Vec3 shift = {{double(a), double(b), double(c)}};
        for (int k = 0; k < 3; ++k) shift[k] *= input.domain.length(k);
        use(x + shift);
      }
}

// φ, written down again.
double kernel_at(const Vec3& r, double w, int dimension) {
  const double u = 1 - dot(r, r) / (w * w), pi = std::numbers::pi;
  return u > 0 ? u * u * u * (dimension == 2 ? 4 / (pi * w * w) : 315 / (64 * pi * w * w * w)) : 0;
}

// Sums over all bodies and contacts with midpoints along lines, and the kinetic stress in two passes.
FieldPoint slow_fields(const FieldInput& input, const Vec3& x, double w) {
  FieldPoint p;
  std::vector<double> weights(input.bodies.size(), 0.0);
  each_image_of(x, input, [&](const Vec3& place) {
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] += kernel_at(place - input.bodies[i].position, w, input.dimension);
    for (const FieldContact& c : input.contacts) {
      const Vec3 start = input.bodies[c.a].position - c.line;
      constexpr int n = 2000;
      double weight = 0;
      if (norm(place - start) < w + norm(c.line))
        for (int k = 0; k < n; ++k)
          weight += kernel_at(place - start - ((k + 0.5) / n) * c.line, w, input.dimension) / n;
      for (int i = 0; i < 9; ++i) p.contact_stress[std::size_t(i)] += weight * c.force[i / 3] * c.line[i % 3];
      if (c.b == FieldContact::wall) p.traction += kernel_at(place - start, w, input.dimension) * c.force;
    }
  });
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const FieldBody& b = input.bodies[i];
    const double r = b.radius, pi = std::numbers::pi;
    p.density += b.mass * weights[i];
    p.momentum += b.mass * weights[i] * b.velocity;
    p.net_force += weights[i] * b.force;
    p.body_force += weights[i] * b.body_force;
    p.group_load += weights[i] * b.group_load;
    p.solid_fraction += weights[i] * (input.dimension == 2 ? pi * r * r : 4 * pi / 3 * r * r * r);
  }
  p.velocity = (1 / p.density) * p.momentum;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Vec3 v = input.bodies[i].velocity - p.velocity;
    for (int k = 0; k < 9; ++k)
      p.kinetic_stress[std::size_t(k)] += input.bodies[i].mass * weights[i] * v[k / 3] * v[k % 3];
  }
  return p;
}

void check_near(const Vec3& a, const Vec3& b, double margin) {
  for (int k = 0; k < 3; ++k) CHECK(a[k] == Approx(b[k]).margin(margin));
}

// Transform of the kernel in 3D at a wave number, by midpoints.
double transform(double w, double wave_number) {
  double sum = 0;
  const int n = 4000;
  for (int k = 0; k < n; ++k) {
    const double r = (k + 0.5) * w / n, kr = wave_number * r;
    sum += kernel_at({{r, 0, 0}}, w, 3) * (kr > 0 ? std::sin(kr) / kr : 1) * 4 * std::numbers::pi * r * r *
           w / n;
  }
  return sum;
}

}  // namespace

TEST_CASE("fields at random points are sums over all bodies, contacts and images", "[fields]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    const FieldInput input = input_of(*simulation);
    const FieldGrid grid = grid_over(packing);
    const double w = 2.3;
    for (int k = 0; k < 12; ++k) {
      Vec3 x = {};
      for (int axis = 0; axis < packing.dimension; ++axis)
        x[axis] = (1.4 * part(random) - 0.2) * cells_along(packing.dimension, axis) * pitch;
      const FieldPoint fast = fields_of(input, at_point(grid, x), AveragingKernel(packing.dimension, w))[0];
      const FieldPoint slow = slow_fields(input, x, w);
      if (!(slow.density > 0)) continue;
      CHECK(fast.density == Approx(slow.density).epsilon(1e-11));
      CHECK(fast.solid_fraction == Approx(slow.solid_fraction).epsilon(1e-11));
      check_near(fast.momentum, slow.momentum, 1e-12);
      check_near(fast.velocity, slow.velocity, 1e-11);
      check_near(fast.net_force, slow.net_force, 1e-10);
      check_near(fast.body_force, slow.body_force, 1e-12);
      check_near(fast.group_load, slow.group_load, 1e-12);
      check_near(fast.traction, slow.traction, 1e-10);
      for (std::size_t c = 0; c < 9; ++c) {
        CHECK(fast.kinetic_stress[c] == Approx(slow.kinetic_stress[c]).margin(1e-12));
        // Midpoints: an error of 1/n² of forces near 50.
        CHECK(fast.contact_stress[c] == Approx(slow.contact_stress[c]).margin(1e-5));
      }
    }
  }
}

// ρ(x) = (m/a³) Σ φ̂(G) cos(G·x) over the reciprocal lattice (Poisson).
TEST_CASE("a cubic lattice has its bulk density and the waves that the kernel leaves", "[fields]") {
  const double a = 1.1, mass = 0.7, w = 1.6 * a;
  FieldInput input;
  input.domain = {{true, true, true}, {}, {{4 * a, 4 * a, 4 * a}}};
  for (int k = 0; k < 64; ++k)
    input.bodies.push_back(
        {.id = k, .mass = mass, .radius = a / 2, .position = {{a * (k % 4), a * (k / 4 % 4), a * (k / 16)}}});
  FieldGrid grid;
  grid.period = {{4 * a, 4 * a, 4 * a}};
  for (const double part : {0.0, 0.13, 0.5}) {
    const Vec3 x = {{a * part, 0.3 * a, 0.9 * a}};
    double waves = 0;
    const int most = 6;  // beyond it the kernel leaves less than 1e-5
    for (int p = -most; p <= most; ++p)
      for (int q = -most; q <= most; ++q)
        for (int r = -most; r <= most; ++r) {
          const double unit = 2 * std::numbers::pi / a;
          waves += transform(w, unit * std::sqrt(double(p * p + q * q + r * r))) *
                   std::cos(unit * (p * x[0] + q * x[1] + r * x[2]));
        }
    const FieldPoint point = fields_of(input, at_point(grid, x), AveragingKernel(3, w))[0];
    CHECK(point.density == Approx(mass / (a * a * a) * waves).epsilon(1e-4));
    CHECK(point.solid_fraction == Approx(std::numbers::pi / 6).epsilon(0.05));
  }
}

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
