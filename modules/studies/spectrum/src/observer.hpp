#pragma once

#include <memory>
#include <vector>

#include <scree/probes.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// The observed columns of a simulation.
class Observer {
 public:
  Observer(const scenario::Plan& plan, std::vector<ObservedColumn> observed);

  // What views must contain.
  std::uint32_t needs() const;
  // The value of each observed column; the first call starts the probes. Throws Error if the scene lacks what
  // a probe reads.
  const std::vector<double>& values(const scree_view& view);
  const std::vector<double>& values(const Simulation& simulation);
  void transfer(const StateTransfer& state);
  // Throws Error if a state had another number of values for a probe than it keeps in this simulation.
  void check_restored(const Simulation& simulation) const;

 private:
  struct Watched {
    std::size_t number;  // of the plan's probe
    Probe probe;
    std::vector<double> row;  // of the last view
  };
  Watched& watched(std::size_t probe);
  // Adds a probe behind those whose columns it reads.
  void watch(std::size_t probe);

  const scenario::Plan& plan_;
  std::vector<ObservedColumn> observed_;
  std::vector<Watched> probes_;  // each after those whose columns it reads
  std::vector<double> values_;
};

// Throws Error at a column without a finite value in the present state, and where a probe lacks what it
// reads.
void check_observed(const scenario::Plan& plan, const std::vector<ObservedColumn>& observed,
                    const Simulation& simulation);

}  // namespace scree::spectrum
