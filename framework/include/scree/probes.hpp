#pragma once

#include <string>
#include <vector>

#include <scree/plugin_host.hpp>
#include <scree/simulation.hpp>

namespace scree {

// Read-only view of a simulation for probes; valid until the next step.
class SimulationView {
 public:
  // with_contacts: whether to collect the contacts, which takes a loop over all pairs.
  SimulationView(const Simulation& simulation, bool with_contacts);
  SimulationView(const SimulationView&) = delete;
  SimulationView& operator=(const SimulationView&) = delete;

  const scree_view& get() const { return view_; }

 private:
  ContactList contacts_;
  scree_energy energy_;
  std::vector<const char*> plane_names_;
  scree_view view_ = {};
};

// A configured probe and its state, such as reference lengths.
class Probe {
 public:
  Probe(const Parameters& parameters, int dimension);

  // Names and units of the columns, without the time column.
  std::vector<std::string> names() const { return names_; }
  std::vector<std::string> units() const { return units_; }
  bool needs_contacts() const { return plugin_.instance().needs & SCREE_NEEDS_CONTACTS; }
  // One row of values. The first call sets the state; it throws Error if the scene lacks what the probe
  // reads.
  std::vector<double> sample(const scree_view& view);
  // Throws Error if the scene lacks what the probe reads; takes no sample.
  void check(const scree_view& view) const;

 private:
  void start(const scree_view& view, std::vector<double>& state) const;

  ConfiguredProbe plugin_;
  std::vector<std::string> names_, units_;
  std::vector<double> state_;
  bool started_ = false;
};

}  // namespace scree
