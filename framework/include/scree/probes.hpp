#pragma once

#include <string>
#include <vector>

#include <scree/plugin_host.hpp>
#include <scree/simulation.hpp>

namespace scree {

// What probes see of a simulation at one moment; valid until the simulation moves on.
class SimulationView {
 public:
  // Contacts are collected only when asked for.
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

// A configured probe and the reference values that it keeps.
class Probe {
 public:
  Probe(const Parameters& parameters, int dimension);

  // Column names and units, without time.
  std::vector<std::string> names() const { return names_; }
  std::vector<std::string> units() const { return units_; }
  bool needs_contacts() const { return plugin_.instance().needs & SCREE_NEEDS_CONTACTS; }
  // One row; the first call takes the references and throws Error if the scene lacks what the probe looks at.
  std::vector<double> sample(const scree_view& view);
  // Checks that the scene has what the probe looks at, without sampling.
  void check(const scree_view& view) const;

 private:
  void start(const scree_view& view, std::vector<double>& state) const;

  ConfiguredProbe plugin_;
  std::vector<std::string> names_, units_;
  std::vector<double> state_;
  bool started_ = false;
};

}  // namespace scree
