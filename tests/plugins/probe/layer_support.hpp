#pragma once

#include "probe_support.hpp"

#include <string>
#include <vector>

#include <scree/state_transfer.hpp>

// A lattice that is strained uniformly: bodies that never meet, at heights h = 0.05, 0.15, ..., 0.95 m along
// an axis, two at each, with the velocity rate (h − 0.5 m) along it.

namespace scree::test {

inline constexpr double lattice_rate = 0.2;  // (1/s)
inline constexpr double lattice_step = 1e-3;
// Round-off of means: each of 400 steps rounds a height of up to 1 m, and the sums over 20 bodies likewise.
inline constexpr double lattice_rounding = 420 * 1.1e-16;

// A value known up to round-off (Approx alone accepts 1e-5 of the value).
inline Catch::Detail::Approx near(double value, double rounding) {
  return Catch::Detail::Approx(value).epsilon(0).margin(rounding);
}

inline const Values lattice_law = {{"normal_stiffness", {5000}}, {"normal_damping", {0}}};

inline Scene lattice(int dimension, int axis) {
  std::vector<Body> bodies;
  for (int row = 0; row < 10; ++row)
    for (const double across : {0.25, 0.75}) {
      Vec3 x = {{across, across, dimension == 3 ? across : 0}}, v = {};
      x[axis] = 0.05 + 0.1 * row;
      v[axis] = lattice_rate * (x[axis] - 0.5);
      bodies.push_back(body(std::int64_t(bodies.size()) + 1, 0.005, 1, x, v, {}, dimension));
    }
  return scene(dimension, lattice_step, bodies, lattice_law);
}

// The same between walls at 0 and 1 m.
inline Scene lattice_in_box(int dimension, int axis) {
  Scene s = lattice(dimension, axis);
  Values box = {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}};
  for (const char* wall : {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"})
    if (wall[0] != 'z' || dimension == 3) box.push_back({wall, {1}});
  add_boundary(s, "box", box);
  return s;
}

inline Probe probe_of(const std::string& plugin, const Values& values, int dimension) {
  return Probe(parameters(plugin, SCREE_PROBE, values), dimension);
}

inline Sampled sampled(Probe& probe, const Simulation& s) {
  return {probe.names(), probe.sample(SimulationView(s, probe.needs()).get())};
}

// A probe of the same parameters that goes on from the state of another, as `scree resume` makes it.
inline Probe resumed(Probe& probe, const std::string& plugin, const Values& values, const Simulation& s) {
  State state;
  probe.transfer(StateTransfer::saving_to(state).below("probe"));
  Probe restored = probe_of(plugin, values, s.dimension());
  restored.transfer(StateTransfer::restoring_from(state).below("probe"));
  restored.check_restored(SimulationView(s, 0).get());
  return restored;
}

// Whether sampling at every 10th of 100 steps leaves the state of colliding discs as it is.
inline bool leaves_the_motion(const std::string& plugin, const Values& values) {
  Scene sc = lattice_in_box(2, 1);
  for (Body& b : sc.bodies) b.radius = 0.051, b.velocity[0] = b.position[1] - b.position[0];
  Simulation with(sc), without(sc);
  Probe probe = probe_of(plugin, values, 2);
  for (int k = 0; k < 100; ++k) {
    if (k % 10 == 0) sampled(probe, with);
    with.step();
    without.step();
  }
  return with.state_hash() == without.state_hash();
}

}  // namespace scree::test
