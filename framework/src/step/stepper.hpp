#pragma once

#include "audit/energy_audit.hpp"
#include "audit/momentum_audit.hpp"
#include "bodies/body_range.hpp"
#include "motion/driven_bodies.hpp"
#include "ranks/rank_sums.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <scree/profile.hpp>

namespace scree {

struct SimulationParts;

// Advances a simulation: calls its parts in the order of a step and counts steps and time.
class Stepper {
 public:
  // What follows a step: an observer, which must see the bodies at its end, or directly the next step.
  enum class Next { observed, follows };
  // Time for which forces, springs, loads and stored energies have been evaluated.
  enum class ForcesAt { end_of_step, middle_of_step };

  explicit Stepper(SimulationParts& parts);

  // After tiles have been dealt to ranks.
  void take_own_parts();

  // Takes one time step. Returns whether the state is sound: finite, no speed and no overlap above its limit.
  // after_substep: called with the length (s) of each substep, after which the bodies are complete.
  bool step(Next next, const std::function<void(double)>* after_substep = nullptr);
  // Evaluates the forces at the present positions; springs advance by `elapsed` (s) since the last
  // evaluation.
  void reevaluate_forces(double elapsed);
  // Evaluates forces and springs at the end of the step if the integrator evaluates them at mid-step.
  void synchronise();
  // Whether initial speeds and overlaps are within the limits of the scene.
  bool initial_state_is_sound() const;

  double time() const { return time_; }  // (s)
  std::uint64_t steps() const { return steps_; }
  ForcesAt forces_at() const { return forces_at_; }
  double max_speed() const;  // largest speed of any body so far (m/s)
  // Sets the clock to the step nearest to a time (s), with the forces of that time.
  void set_time(double time);
  // Sets the clock to t = 0 and keeps how far the forces are behind.
  void begin_anew();
  // Between steps, when no next step has begun.
  void transfer(const class StateTransfer& state);
  // How far forces are behind in a state (s).
  static double forces_behind(const class State& state);

 private:
  // Motion of the bodies of a part after their forces have been evaluated: second half of this substep and,
  // unless the bodies are observed in between, first half of the next (s).
  struct Moves {
    std::optional<double> finish = std::nullopt, begin = std::nullopt;
  };
  // Sums over the bodies of a part.
  struct PartSums {
    BodySums bodies;
    MomentumAudit::Sums momentum;
    double square_speed = 0;
    bool finite = true;
    double work = 0,
           work_to_begin = 0;  // on driven bodies, and by the loads with which the next step begins (J)

    void add(const PartSums& other) {
      bodies += other.bodies;
      momentum.add(other.momentum);
      finite &= other.finite;
      work += other.work;
      work_to_begin += other.work_to_begin;
    }
  };

  // Takes one substep and, if `next` is given, the first half of the next for the bodies (s). Returns the
  // largest squared speed (m²/s²); infinite if any velocity or spin is not finite at the end, nothing if
  // bodies or walls could not be moved.
  std::optional<double> substep(double step, std::optional<double> next);
  void begin_bodies(const DrivenBodies::Times& times);
  // The same for a part with driven bodies, and what finish_part does for it.
  void begin_driven(std::size_t part, BodyRange bodies, double step, PartSums& sums);
  void move_driven(std::size_t part, BodyRange bodies, const Moves& moves, PartSums& sums);
  // Before an evaluation that ends a substep, after which one of `next` (s) follows.
  void plan_driven(const DrivenBodies::Times& now, std::optional<double> next);
  struct Clock {
    double time, force_time;  // (s)
  };
  // As the clock will show after this substep.
  Clock clock_after_substep(double step, double elapsed) const;
  void add_work_of_begun_step();
  // First half of a step (s) for the walls; the bodies are at its end, where forces act for `kick` (s).
  void begin_walls(double step, double kick);
  void move_walls(double step, double kick);
  // Second half (s).
  void finish_walls(double step);
  // Largest squared speed of the bodies of this rank (m²/s²).
  double largest_of_parts() const;
  // Sums over all bodies, exact over tiles, so that their bits depend on no order of the tiles.
  void add_total(PartSums& all, RankSums& sums) const;
  PartSums total_of_tile(std::size_t tile) const;
  // Evaluates forces and finishes all parts. Returns whether velocities and spins are finite.
  bool evaluate_forces(double elapsed, const Moves& moves);
  // Of the bodies that this process moves.
  void clear_loads();
  // Rotates bodies about the spins with which `moves` has moved them.
  void rotate(BodyRange bodies, const Moves& moves);
  // Audits, body forces and motion of a part, after all its contact loads are summed.
  void finish_part(std::size_t part, const Moves& moves, Profile* profile);
  bool too_fast(double square_speed) const;
  bool too_deep() const;
  // Whether an overlap may exceed the limit after motions of at most `distance` (m).
  bool may_become_too_deep(double distance) const;

  SimulationParts& parts_;
  BodyTiles tiles_;
  std::vector<std::uint32_t> own_parts_;  // of this rank
  std::vector<PartSums> part_sums_;
  bool bodies_advanced_ = false;   // the first half of the next substep has been taken
  double begun_square_speed_ = 0;  // largest of it (m²/s²)
  double time_ = 0;                // (s)
  double force_time_ = 0;          // (s) of the last force evaluation
  double evaluated_at_ = 0;        // (s) of the one that goes on
  ForcesAt forces_at_ = ForcesAt::end_of_step;
  std::uint64_t steps_ = 0;
  std::size_t substep_ = 0;      // of the step that is taken
  double max_square_speed_ = 0;  // (m²/s²)
};

}  // namespace scree
