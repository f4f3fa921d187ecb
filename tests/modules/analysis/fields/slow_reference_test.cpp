#include "field_scenes.hpp"

#include <numbers>

#include <catch2/catch.hpp>

#include <scree/fields/field_sums.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

FieldPoint field_at(const FieldInput& input, const FieldGrid& like, const Vec3& place, double w,
                    KernelShape shape = KernelShape::triweight) {
  FieldGrid grid = like;
  grid.first = place;
  grid.count = {1, 1, 1};
  FieldSums sums(grid, AveragingKernel(like.dimension, w, shape));
  ThreadPool one(1);
  sums.add(input, one);
  return sums.means()[0];
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

// φ, written down again; that of Lucy as a polynomial of r, as MercuryCG has it.
double kernel_at(const Vec3& r, double w, int dimension, KernelShape shape = KernelShape::triweight) {
  if (shape == KernelShape::lucy) {
    const double q = norm(r) / w,
                 volume = std::numbers::pi * (dimension == 2 ? w * w / 5 : 16 * w * w * w / 105);
    return q < 1 ? (1 - 6 * q * q + 8 * q * q * q - 3 * q * q * q * q) / volume : 0;
  }
  const double u = 1 - dot(r, r) / (w * w), pi = std::numbers::pi;
  return u > 0 ? u * u * u * (dimension == 2 ? 4 / (pi * w * w) : 315 / (64 * pi * w * w * w)) : 0;
}

// ∫f ds by the tanh-sinh rule, whose error is round-off also where derivatives are infinite at an end (H. Takahasi,
// M. Mori, Publ. RIMS 9, 721 (1974)).
template <class Function>
double integral(double from, double to, const Function& f) {
  if (!(from < to)) return 0;
  constexpr double step = 1.0 / 16;
  double sum = 0;
  for (int k = -52; k <= 52; ++k) {
    const double t = k * step, u = std::numbers::pi / 2 * std::sinh(t), s = std::tanh(u), c = std::cosh(u);
    sum += f(0.5 * (from + to) + 0.5 * (to - from) * s) * std::numbers::pi / 2 * std::cosh(t) / (c * c);
  }
  return 0.5 * (to - from) * step * sum;
}

// ∫₀¹ φ(r − s l) ds, in pieces between the place nearest to r and those at which φ ends.
double kernel_along(const Vec3& r, const Vec3& l, double w, int dimension, KernelShape shape) {
  const double square = dot(l, l), nearest = dot(r, l) / square, apart = norm(r - nearest * l);
  if (!(apart < w)) return 0;
  const double half = std::sqrt((w * w - apart * apart) / square), middle = std::clamp(nearest, 0.0, 1.0);
  const auto phi = [&](double s) { return kernel_at(r - s * l, w, dimension, shape); };
  return integral(std::max(0.0, nearest - half), std::min(middle, nearest + half), phi) +
         integral(std::max(middle, nearest - half), std::min(1.0, nearest + half), phi);
}

// Sums over all bodies and contacts as Goldhirsch (2010) defines the fields, and the kinetic
// stress in two passes.
FieldPoint slow_fields(const FieldInput& input, const Vec3& x, double w, KernelShape shape) {
  FieldPoint p;
  std::vector<double> weights(input.bodies.size(), 0.0);
  each_image_of(x, input, [&](const Vec3& place) {
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] += kernel_at(place - input.bodies[i].position, w, input.dimension, shape);
    for (const FieldContact& c : input.contacts) {
      const Vec3 start = input.bodies[c.a].position - c.line;
      const double weight = kernel_along(place - start, c.line, w, input.dimension, shape);
      for (int i = 0; i < 9; ++i) p.contact_stress[std::size_t(i)] += weight * c.force[i / 3] * c.line[i % 3];
      const double at_b = kernel_at(place - start, w, input.dimension, shape);
      p.stress_divergence += (at_b - kernel_at(place - start - c.line, w, input.dimension, shape)) * c.force;
      if (c.b == FieldContact::wall) p.traction += at_b * c.force;
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

void check_same_vector(const Vec3& a, const Vec3& b, double margin) {
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
    for (int k = 0; k < 16; ++k) {
      const auto shape = KernelShape(k % 2);
      Vec3 x = {};
      for (int axis = 0; axis < packing.dimension; ++axis)
        x[axis] = (1.4 * part(random) - 0.2) * cells_along(packing.dimension, axis) * pitch;
      const FieldPoint fast = field_at(input, grid, x, w, shape);
      const FieldPoint slow = slow_fields(input, x, w, shape);
      if (!(slow.density > 0)) continue;
      // The polynomial of Lucy is a difference of numbers near 1 where it ends.
      CHECK(fast.density == Approx(slow.density).epsilon(1e-11).margin(1e-14));
      CHECK(fast.solid_fraction == Approx(slow.solid_fraction).epsilon(1e-11).margin(1e-14));
      check_same_vector(fast.momentum, slow.momentum, 1e-12);
      check_same_vector(fast.velocity, slow.velocity, 1e-11);
      check_same_vector(fast.net_force, slow.net_force, 1e-10);
      check_same_vector(fast.body_force, slow.body_force, 1e-12);
      check_same_vector(fast.group_load, slow.group_load, 1e-12);
      check_same_vector(fast.traction, slow.traction, 1e-10);
      check_same_vector(fast.stress_divergence, slow.stress_divergence, 1e-10);
      for (std::size_t c = 0; c < 9; ++c) {
        CHECK(fast.kinetic_stress[c] == Approx(slow.kinetic_stress[c]).margin(1e-12));
        // Some hundred terms of forces near 50.
        CHECK(fast.contact_stress[c] == Approx(slow.contact_stress[c]).margin(1e-10));
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
    const FieldPoint point = field_at(input, grid, x, w);
    CHECK(point.density == Approx(mass / (a * a * a) * waves).epsilon(1e-4));
    CHECK(point.solid_fraction == Approx(std::numbers::pi / 6).epsilon(0.05));
  }
}
