#pragma once

#include "start.hpp"

#include <vector>

#include <scree/scene.hpp>
#include <scree/simulation.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// A displacement of the driven wall as a function of time, in the form of program.hpp.
using Wave = std::vector<double>;

// Gives the driven wall of a scene the wave as its displacement.
void set_wave(Scene& scene, const SpectrumPlan& plan, const Wave& wave);

// The same for a simulation between two steps; the wave begins now.
void start_wave(Simulation& simulation, const SpectrumPlan& plan, const Wave& wave);

// How walls follow the drive.
class DrivenWalls {
 public:
  DrivenWalls() = default;  // for transfer()
  // From the velocities of walls in a copy of the simulation. Throws Error if the drive moves no wall.
  explicit DrivenWalls(const Start& start);

  // Displacement of each wall (m) for a drive of 1 m.
  const std::vector<Vec3>& motion() const { return motion_; }
  // Whether nothing but the drive moves them, so that the drive follows from their position.
  bool are_prescribed() const { return prescribed_; }
  // The drive (m) that follows from the position of the walls; only if they are prescribed.
  double drive_of(const Simulation& simulation) const;
  void transfer(const StateTransfer& state);
  // Throws Error if a state had another number of walls.
  void check_restored(const StateTransfer& state, std::size_t walls) const;

 private:
  std::vector<Vec3> motion_, at_rest_;
  double square_ = 0;
  bool prescribed_ = true;
};

// Throws Error if an amplitude of the wave (m) is lost in the round-off of positions.
void check_amplitude(const Start& start, double amplitude);

}  // namespace scree::spectrum
