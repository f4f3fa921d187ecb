#include "law_variants.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <catch2/catch.hpp>

#include <scree/plugin/great_circle.hpp>

// The derivatives of every law against finite differences of fourth order. With steps of 1e-3 of the scale of
// each quantity, their truncation error is about 1e-12 and their round-off, 1e-16 × |f|/step, below 1e-11 of
// the largest derivative; 1e-7 leaves room for states near a kink.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tolerance = 1e-7, law_step = 1e-6, centre_distance = 4e-3;

// One touching pair, and changes of its relative motion.
struct State {
  int dimension;
  Vec3 normal;
  double overlap = 2e-5;
  Vec3 spring = {}, increment = {}, velocity = {}, spin = {};
  bool was_sliding = false;
  Vec3 rotation_a = {}, rotation_b = {};  // (rad) as components of a motion
};

// The spring of a law for discs; painted points lie so that it is as long.
void load_disc_history(LawBatch& pair, const State& state) {
  const double angle = std::atan2(state.normal[1], state.normal[0]);
  const double length = state.spring[1] * state.normal[0] - state.spring[0] * state.normal[1];
  pair.set_history("spring", length);
  pair.set_history("sliding", state.was_sliding ? 1 : 0);
  pair.set_history("painted_a", 2.4e-3 * angle - 0.5 * length);
  pair.set_history("painted_b", 1.6e-3 * angle - 0.5 * length);
  pair.set_history("angle", angle);
  pair.set_history("touched", 1);
}

// Painted points of a law for spheres such that the spring is that of the state; the bodies have not turned.
void load_sphere_history(LawBatch& pair, const State& state) {
  const Vec3 a = end_of_arc(-state.normal, 0.5 / 2.4e-3 * state.spring),
             b = end_of_arc(state.normal, -0.5 / 1.6e-3 * state.spring);
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    pair.set_history("painted_a_" + axis, a[k]);
    pair.set_history("painted_b_" + axis, b[k]);
    pair.set_history("spring_" + axis, state.spring[k]);
  }
  pair.set_history("sliding", state.was_sliding ? 1 : 0);
  pair.set_history("signed_contact_radius", (state.was_sliding ? 1 : -1) * std::sqrt(1e-3 * 1.9e-5));
}

// The orientation after a rotation (rad): an angle, the first component, in 2D, and a unit quaternion in 3D.
void set_orientation(LawBatch& pair, scree_contact_input column, int dimension, const Vec3& rotation) {
  if (dimension == 2) {
    pair.input(column) = rotation[0];
    return;
  }
  const double angle = norm(rotation), share = angle > 0 ? std::sin(0.5 * angle) / angle : 0.5;
  pair.input(column) = std::cos(0.5 * angle);
  for (int k = 0; k < 3; ++k) pair.input(column, 1 + k) = share * rotation[k];
}

// The change of a state by `amount` in component k of a motion.
State moved(const State& state, PairMotion motion, int k, double amount) {
  State s = state;
  Vec3 displacement = {};
  displacement[k] = amount;
  // The law receives overlap and increment to first order along the old normal.
  const Vec3 across = displacement - dot(displacement, state.normal) * state.normal;
  switch (motion) {
    case PairMotion::centres: {
      const Vec3 separation = centre_distance * state.normal + displacement;
      s.normal = (1 / norm(separation)) * separation;
      s.overlap -= amount * state.normal[k];
      s.increment += across;
      break;
    }
    case PairMotion::surfaces:
      s.increment += across;
      break;
    case PairMotion::rotation_a:
      s.rotation_a = displacement;
      break;
    case PairMotion::rotation_b:
      s.rotation_b = displacement;
      break;
    case PairMotion::velocity:
      s.velocity += displacement;
      break;
    case PairMotion::spin:
      s.spin += displacement;
      break;
  }
  return s;
}

int rows_of(int dimension) { return dimension == 2 ? 3 : 6; }

void load(LawBatch& pair, const State& state, PairMotion motion, int k, double amount) {
  const int d = state.dimension;
  const State s = moved(state, motion, k, amount);
  set_orientation(pair, SCREE_ORIENTATION_A, d, s.rotation_a);
  set_orientation(pair, SCREE_ORIENTATION_B, d, s.rotation_b);
  pair.set(SCREE_NORMAL, s.normal);
  pair.input(SCREE_OVERLAP) = s.overlap;
  pair.set(SCREE_RELATIVE_VELOCITY, s.velocity);
  pair.set(SCREE_TANGENTIAL_INCREMENT, s.increment);
  pair.set(SCREE_RELATIVE_SPIN, s.spin);
  pair.input(SCREE_EFFECTIVE_RADIUS) = 1e-3;
  pair.input(SCREE_RADII, 0) = 2.4e-3;
  pair.input(SCREE_RADII, 1) = 1.6e-3;
  pair.input(SCREE_REDUCED_MASS) = 4e-6;
  if (pair.has_history("spring")) return load_disc_history(pair, state);
  if (pair.has_history("painted_a_x")) return load_sphere_history(pair, state);
  const std::uint32_t width = pair.instance().history_width;
  for (std::uint32_t h = 0; h < width; ++h)
    pair.history(h) = h < std::uint32_t(d) ? s.spring[int(h)] : (s.was_sliding ? 1 : 0);
  // Hertz-Mindlin keeps the contact radius with the sign of sliding.
  if (width > 0 && (pair.instance().reads & (1u << SCREE_CONTACT_RADIUS)))
    pair.history(std::size_t(d)) = (s.was_sliding ? 1 : -1) * std::sqrt(1e-3 * 1.9e-5);
}

using Rows = std::array<double, 6>;  // components of the force, then of the couple

Rows response(LawBatch& pair, const State& state, PairMotion motion, int k, double amount) {
  const int d = state.dimension;
  load(pair, state, motion, k, amount);
  pair.evaluate(law_step);
  Rows rows = {};
  for (int row = 0; row < rows_of(d); ++row)
    rows[std::size_t(row)] = row < d ? pair.output(SCREE_FORCE, row) : pair.output(SCREE_COUPLE, row - d);
  return rows;
}

Rows difference(LawBatch& pair, const State& state, PairMotion motion, int k, double amount) {
  const auto at = [&](double share) { return response(pair, state, motion, k, share * amount); };
  const Rows near = at(1), near_below = at(-1), far = at(2), far_below = at(-2);
  Rows slope = {};
  for (std::size_t row = 0; row < slope.size(); ++row)
    slope[row] = (8 * (near[row] - near_below[row]) - (far[row] - far_below[row])) / (12 * amount);
  return slope;
}

// Typical size of a motion: overlap, overlap over radius, velocity, spin.
double scale_of(PairMotion motion) {
  switch (motion) {
    case PairMotion::velocity:
      return 0.1;
    case PairMotion::spin:
      return 50;
    case PairMotion::rotation_a:
    case PairMotion::rotation_b:
      return 1e-2;
    default:
      return 2e-5;
  }
}

std::vector<State> states(int dimension, double slip_length) {
  std::vector<State> all;
  for (const double angle : {0.0, 0.7, 2.5})
    for (const double extent : {0.2, 0.5, 3.0})  // of the spring, relative to the length at which it slides
      for (const bool was_sliding : {false, true})
        for (const double approach : {0.05, -0.05}) {
          State s{.dimension = dimension, .normal = {{std::cos(angle), std::sin(angle), 0}}};
          Vec3 across = {{-std::sin(angle), std::cos(angle), 0}};
          if (dimension == 3) {
            s.normal = {{0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6}};
            across = {{-std::sin(angle), std::cos(angle), 0}};
          }
          const Vec3 second = dimension == 3 ? cross(s.normal, across) : Vec3{};
          s.spring = extent * slip_length * (0.8 * across + 0.3 * second);
          s.increment = 0.02 * slip_length * (across - 0.5 * second);
          s.velocity = 0.03 * across + 0.02 * second - approach * s.normal;
          s.spin = dimension == 2 ? Vec3{{30, 0, 0}} : Vec3{{30, -20, 10}};
          s.was_sliding = was_sliding;
          all.push_back(s);
        }
  return all;
}

// Largest deviation of the Jacobian from finite differences, relative to the largest derivative of its
// column group; counts the states in which the contact slides.
double largest_deviation(const Variant& variant, int dimension, int& sliding) {
  double worst = 0;
  for (const State& state : states(dimension, variant.slip)) {
    LawBatch pair(variant.law, variant.values, dimension);
    load(pair, state, PairMotion::centres, 0, 0);
    const LawBatch::Derivatives exact = pair.derivatives(1 / centre_distance, law_step);
    for (int m = 0; m < pair_motions; ++m) {
      const auto motion = PairMotion(m);
      const double scale = scale_of(motion), force = variant.stiffness * state.overlap / scale;
      for (int k = 0; k < motion_components(motion, dimension); ++k) {
        const Rows numeric = difference(pair, state, motion, k, 1e-3 * scale);
        for (int row = 0; row < rows_of(dimension); ++row) {
          // Forces and couples have different units.
          const double unit = row < dimension ? force : force * 1e-3;
          worst = std::max(worst, std::abs(exact(row, motion, k) - numeric[std::size_t(row)]) / unit);
        }
      }
    }
    load(pair, state, PairMotion::centres, 0, 0);
    pair.evaluate(law_step);
    const int column = pair.instance().sliding_column;
    sliding += column >= 0 && pair.history(std::size_t(column)) > 0;
  }
  return worst;
}

}  // namespace

TEST_CASE("the derivatives of every law agree with finite differences", "[derivative]") {
  std::map<std::string, int> tested;
  for (const Variant& variant : variants())
    for (const int dimension : dimensions_of(parameters(variant.law, SCREE_CONTACT_LAW, variant.values))) {
      INFO(variant.law << ", " << variant.name << ", " << dimension << "D");
      int sliding = 0;
      CHECK(largest_deviation(variant, dimension, sliding) < tolerance);
      // A third of the springs is far beyond the limit of friction, a third far below.
      if (variant.frictional) {
        CHECK(sliding >= 12);
        CHECK(sliding <= 24);
      }
      ++tested[variant.law];
    }
  for (const std::string& law : host().names(SCREE_CONTACT_LAW)) {
    INFO(law << " has no variants in this test");
    CHECK(tested[law] > 0);
  }
}

TEST_CASE("derivatives leave history and outputs as they are, and are 0 for pairs apart", "[derivative]") {
  LawBatch pair("linear_spring_dashpot", {{"normal_stiffness", {5000}},
                                          {"normal_damping", {0}},
                                          {"tangential_stiffness", {1000}},
                                          {"static_friction", {0.5}}});
  pair.set(SCREE_NORMAL, {{1, 0, 0}});
  pair.input(SCREE_OVERLAP) = 1e-4;
  pair.history(1) = 1e-5;
  pair.evaluate(law_step);
  const double force = pair.output(SCREE_FORCE), spring = pair.history(1);
  const LawBatch::Derivatives touching = pair.derivatives(0, law_step);
  CHECK(touching(0, PairMotion::centres, 0) == -5000);
  CHECK(touching(1, PairMotion::centres, 1) == -1000);
  CHECK(pair.output(SCREE_FORCE) == force);
  CHECK(pair.history(1) == spring);
  pair.input(SCREE_OVERLAP) = -1e-4;
  const LawBatch::Derivatives apart = pair.derivatives(0, law_step);
  CHECK(apart(0, PairMotion::centres, 0) == 0);
  CHECK(apart(1, PairMotion::centres, 1) == 0);
}
