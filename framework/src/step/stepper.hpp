#pragma once

#include "audit/energy_audit.hpp"
#include "audit/momentum_audit.hpp"
#include "bodies/body_range.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <scree/profile.hpp>

namespace scree {

struct SimulationParts;

// Takes the steps of a simulation: calls its parts in the order of a step and keeps the time.
class Stepper {
 public:
  // What comes after a step: the next step, or an observer that must find the bodies at the end of this one.
  enum class Next { observed, follows };
  // For which moment forces, springs, loads and stored energies are known.
  enum class ForcesAt { end_of_step, middle_of_step };

  explicit Stepper(SimulationParts& parts);

  // One time step. Returns whether the motion is sound: finite, no body too fast, no overlap too deep.
  bool step(Next next);
  // Evaluates the forces where the bodies are; springs move by `elapsed` since the last evaluation (s).
  void evaluate_forces_afresh(double elapsed);
  // Brings forces and springs to the end of the step, where an integrator has evaluated them in its middle.
  void catch_up();
  // Whether bodies and overlaps are within the limits as the scene states them.
  bool starts_sound() const;

  double time() const { return time_; }  // (s)
  std::uint64_t steps() const { return steps_; }
  ForcesAt forces_at() const { return forces_at_; }
  double max_speed() const;  // of any body so far (m/s)

 private:
  // What moves the bodies of a part after the evaluation of their forces: the end of this substep and, unless
  // they are observed before, the beginning of the next (s).
  struct Moves {
    std::optional<double> finish = std::nullopt, begin = std::nullopt;
  };
  // What the bodies of a part add up to.
  struct PartSums {
    BodySums bodies;
    MomentumAudit::Sums momentum;
    double square_speed = 0;
    bool finite = true;
  };

  // Moves everything by one substep and, with `next`, bodies into the next one (s). Returns the largest
  // squared speed of the move (m²/s²); infinite if any velocity or spin is not a number at its end, nothing
  // if bodies or walls could not be moved.
  std::optional<double> substep(double step, std::optional<double> next);
  void begin_bodies(double step);
  double largest_square_speed() const;
  // Returns whether velocities and spins are numbers.
  bool evaluate_forces(double elapsed, const Moves& moves);
  // Completes a part of the bodies once all contacts have loaded them.
  void finish_part(std::size_t part, const Moves& moves, Profile* profile);
  bool too_fast(double square_speed) const;
  bool too_deep() const;
  // Whether an overlap may be beyond the limit once nothing has moved further than `distance` (m).
  bool may_become_too_deep(double distance) const;

  SimulationParts& parts_;
  BodyTiles tiles_;
  std::vector<PartSums> part_sums_;
  bool bodies_have_begun_ = false;  // the next substep
  double time_ = 0;                 // (s)
  double force_time_ = 0;           // (s) at which forces were evaluated last
  ForcesAt forces_at_ = ForcesAt::end_of_step;
  std::uint64_t steps_ = 0;
  double max_square_speed_ = 0;  // (m²/s²)
};

}  // namespace scree
