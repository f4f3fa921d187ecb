#pragma once

#include "step/simulation_parts.hpp"

#include <string>
#include <vector>

#include <scree/branching.hpp>
#include <scree/simulation.hpp>

namespace scree {

// Takes what a new simulation needs from the state of another. If nothing differs, everything is taken over and
// only clocks and balances begin anew; else the differences act as those of a stage that begins.
class Branch {
 public:
  // Throws Error if something in the state has no place in the scene.
  Branch(const Scene& scene, const State& state, const Branching& branching);

  // The scene to be set up: boundaries that are taken over have the parameters that they have in the state.
  const Scene& scene() const { return scene_; }
  // Called once after the parts have been set up.
  void take_over(Simulation& simulation, SimulationParts& parts);
  // Lines for people: what was taken over.
  const std::vector<std::string>& report() const { return report_; }

 private:
  struct Wall {
    std::size_t from, to;  // boundary in the state and in the scene
  };
  void match_walls();
  bool nothing_differs() const;
  void take_over_all(SimulationParts& parts);
  void take_over_by_name(Simulation& simulation, SimulationParts& parts);
  void take_over_orientations(SimulationParts& parts);
  std::size_t take_over_histories(SimulationParts& parts);  // returns the number of contacts
  // The plane here of each plane in the state.
  std::vector<std::uint32_t> planes_here(const SimulationParts& parts) const;

  const Scene& wanted_;
  const State& state_;
  Branching branching_;
  Scene scene_;
  std::vector<Wall> walls_;
  std::vector<std::string> report_;
};

}  // namespace scree
