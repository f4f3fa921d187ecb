#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <scree/body_group.hpp>
#include <scree/domain.hpp>
#include <scree/plugin/vec.hpp>
#include <scree/simulation.hpp>

namespace scree::fields {

struct FieldBody {
  std::int64_t id = 0;
  double mass = 0, radius = 0;             // (kg), (m)
  Vec3 position = {}, velocity = {};       // (m), (m/s)
  std::array<std::int32_t, 3> image = {};  // periods crossed along each axis
  Vec3 force = {};                         // (N) as the kernel adds it up; without what holds the body
  Vec3 body_force = {}, group_load = {};   // (N) the parts of it that no contact exerts
  freedom::Mask held = 0;                  // components that something else moves

  bool is_held(int k) const { return freedom::is_in(held, k); }
};

// A contact as a straight line, from the centre of b, or from where a wall is touched, to the centre of a.
struct FieldContact {
  static constexpr std::uint32_t wall = ~std::uint32_t(0);
  std::uint32_t a = 0, b = wall;  // indices into the bodies; b: `wall` at a wall
  Vec3 line = {}, force = {};     // (m), (N) on a
};

// What fields are computed from: a scene at one time.
struct FieldInput {
  int dimension = 3;
  double time = 0;  // (s)
  std::uint64_t step = 0;
  Domain domain = {};
  std::vector<FieldBody> bodies = {};  // in the order of their ids
  std::vector<FieldContact> contacts = {};
};

// Whether the forces of a simulation between two steps belong to its present positions and velocities.
// position_verlet has forces of mid-step, and drag is evaluated at velocities that a step predicts.
// Otherwise Simulation::apply_reconfiguration() evaluates all forces at the present time.
bool forces_are_present(const Simulation& simulation);

// Of a simulation with forces of contacts (Scene::pair_forces), between two steps.
FieldInput input_of(const Simulation& simulation);

// The same after a step or substep of this length (s; default: the step). Body forces are those of the step,
// which evaluates them at velocities that it predicts: v + h F/m; with position_verlet at mid-step; with
// predictor_corrector at positions and velocities that follow from the last three of `earlier`. earlier: the
// inputs after the steps before, the latest last.
FieldInput input_after_step(const Simulation& simulation, std::span<const FieldInput> earlier,
                            std::optional<double> length = std::nullopt);

}  // namespace scree::fields
