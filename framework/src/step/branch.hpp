#pragma once

#include "step/simulation_parts.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <scree/branching.hpp>
#include <scree/simulation.hpp>

namespace scree {

// Takes what a new simulation needs from the state of another. If nothing differs, everything is taken over
// and only clocks and balances begin anew; else the differences act as `set` does when a stage begins.
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
  // "<what>; <cure>" of what the state has and the scene loses.
  const std::vector<std::string>& let_go() const { return let_go_; }

 private:
  // Contacts of the state whose histories have no place.
  struct Dropped {
    // Left out; of walls that are; between fixed bodies; of absent walls or laws; of another length.
    std::size_t asked = 0, of_walls = 0, of_fixed = 0, of_absent = 0, of_laws = 0;
    std::size_t all() const { return asked + of_walls + of_fixed + of_absent + of_laws; }
  };
  struct Wall {
    std::size_t from, to;  // boundary in the state and in the scene
  };
  void match_walls();
  bool nothing_differs() const;
  void take_over_all(SimulationParts& parts);
  void take_over_by_name(Simulation& simulation, SimulationParts& parts);
  void take_over_orientations(SimulationParts& parts);
  // For laws that follow bodies along walls across periodic faces.
  void take_over_images(SimulationParts& parts) const;
  std::size_t take_over_histories(SimulationParts& parts);  // returns the number of contacts
  // Visits the row of each contact of the state, with its numbers there; returns the contacts without one.
  using VisitRow = std::function<void(PairGroup& group, std::size_t row, std::span<const double> numbers)>;
  Dropped each_row(SimulationParts& parts, const VisitRow& visit) const;
  // After the forces have been evaluated without a motion: what springs have lost (J) of the elastic energy
  // before goes into the balance, and is reported.
  void count_lost(SimulationParts& parts);
  void report_cut(SimulationParts& parts, double lost, double before);
  void report_dropped(double energy, double before);
  // The number here of each wall in the state.
  std::vector<std::uint32_t> walls_here(const SimulationParts& parts) const;

  const Scene& wanted_;
  const State& state_;
  Branching branching_;
  Scene scene_;
  std::vector<Wall> walls_;
  Dropped dropped_;
  std::vector<std::string> report_, let_go_;
};

}  // namespace scree
