#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <scree/plugin_host.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

// What is needed by two probes together.
constexpr std::uint32_t joint_needs(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t nothing_of = SCREE_NEEDS_NO_BODIES;
  return ((a | b) & ~nothing_of) | (a & b & nothing_of);
}

// Numbers of bodies, in increasing order; none: all bodies.
using ListedBodies = std::optional<std::vector<std::uint32_t>>;

// Read-only view of a simulation for probes; valid until the next step.
class SimulationView {
 public:
  // needs: SCREE_NEEDS_CONTACTS takes a loop over all pairs, SCREE_NEEDS_ENERGY one over all bodies, and so
  // do bodies that have been sorted in memory, unless SCREE_NEEDS_NO_BODIES. end_time: (s) of the run, if it
  // is known. listed: bodies whose state is read.
  SimulationView(const Simulation& simulation, std::uint32_t needs,
                 double end_time = std::numeric_limits<double>::quiet_NaN(), const ListedBodies& listed = {});
  SimulationView(const SimulationView&) = delete;
  SimulationView& operator=(const SimulationView&) = delete;

  const scree_view& get() const { return view_; }

 private:
  void show_bodies(const Simulation& simulation, const ListedBodies& listed);
  void show_boundaries(const Simulation& simulation);
  void show_contacts(const Simulation& simulation);

  ContactList contacts_;
  scree_energy energy_;
  std::vector<const char*> plane_names_, material_names_;
  scree_view view_ = {};
};

// A configured probe and its state, such as reference lengths. The first call that is given a view starts it.
class Probe {
 public:
  // left_out: 1 for bodies that it does not count; empty: it counts all. Throws Error if the plug-in refuses
  // its parameters or names columns as a CSV file cannot.
  Probe(const Parameters& parameters, int dimension, std::vector<std::uint8_t> left_out = {});

  // Names and units of the columns, without the time column, and what they mean; empty where the plug-in says
  // nothing.
  std::vector<std::string> names() const { return names_; }
  std::vector<std::string> units() const { return units_; }
  std::vector<std::string> meanings() const;
  std::uint32_t needs() const { return plugin_.instance().needs; }
  // The bodies that observe() and sample() read: marked by the plug-in once it has started, or all.
  const ListedBodies& listed_bodies() const { return listed_; }
  // Whether observe() does anything.
  bool observes() const { return plugin_.instance().observes; }
  // Whether it can count some of the bodies only.
  bool leaves_out() const { return plugin_.instance().leaves_out; }

  // Time between observations that the plug-in has chosen (s); 0 if it leaves that to the scenario.
  double observe_every() const { return plugin_.instance().observe_every; }

  // Updates the state. inputs: values of the columns of other probes that this one reads, in the order of
  // Parameters::inputs(). Throws Error, as sample() does, if the scene lacks what the probe reads.
  void observe(const scree_view& view, std::span<const double> inputs = {});
  // One row of values.
  std::vector<double> sample(const scree_view& view, std::span<const double> inputs = {});
  // Throws Error if the scene lacks what the probe reads; leaves the state as it is. Returns the number of
  // bodies that it will read.
  std::size_t check(const scree_view& view) const;
  // What the probe keeps.
  void transfer(const StateTransfer& state);
  // Throws Error if what was restored has not the size that the plug-in expects.
  void check_restored(const scree_view& view) const;
  // Empty before the first observation or sample.
  std::span<const double> state() const { return {state_.data(), state_size_}; }

 private:
  // Calls with the view as this probe is to see it. inputs: as of observe().
  template <class Call>
  auto show(const scree_view& view, std::span<const double> inputs, const Call& call) const;
  // Numbers of the state.
  std::uint64_t size_in(const scree_view& view) const;
  // The state at the start.
  std::vector<double> started(const scree_view& view) const;
  void start_once(const scree_view& view);
  // The bodies that the plug-in marks, if these are not all.
  ListedBodies marked(const scree_view& view, const std::vector<double>& state) const;

  ConfiguredProbe plugin_;
  std::vector<std::string> names_, units_;
  std::vector<std::uint8_t> left_out_;
  std::vector<double> state_;  // with a guard behind the numbers of the state
  std::size_t state_size_ = 0;
  bool is_started_ = false, is_listed_ = false;
  ListedBodies listed_;
};

}  // namespace scree
