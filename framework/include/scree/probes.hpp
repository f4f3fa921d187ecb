#pragma once

#include <cstdint>
#include <functional>
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
  void show_boundaries(const Simulation& simulation);

  ContactList contacts_;
  scree_energy energy_;
  std::vector<const char*> plane_names_, surface_names_, material_names_;
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
  // Of the scene.
  std::uint32_t needs() const { return plugin_.instance().needs; }
  // Of the next view, where totals are given: after the start no bodies then.
  std::uint32_t view_needs() const;
  // The bodies that observe() and sample() read: marked by the plug-in once it has started, or all; none
  // where totals are given.
  const ListedBodies& listed_bodies() const { return listed_; }
  // Whether observe() does anything.
  bool observes() const { return plugin_.instance().observes; }
  // Whether it can count some of the bodies only.
  bool leaves_out() const { return plugin_.instance().leaves_out; }

  // Time between observations that the plug-in has chosen (s); 0 if it leaves that to the scenario.
  double observe_every() const { return plugin_.instance().observe_every; }

  // Whether its columns follow from totals over the bodies and contacts of all parts of a scene.
  bool has_totals() const { return plugin_.instance().total_count > 0; }
  // The totals of all parts: of_pass(pass, before) adds up the parts in a pass, after `before` in earlier
  // ones.
  using OfPass = std::function<std::vector<double>(std::uint32_t pass, const std::vector<double>& before)>;
  std::vector<double> totals(const OfPass& of_pass) const;
  // What a part gives in a pass. Throws Error if the plug-in throws, or a largest value is NaN.
  std::vector<double> totals_of_part(const scree_view& part, std::uint32_t pass) const;
  // Of the totals, from this one on they are largest values.
  std::size_t first_largest() const {
    return plugin_.instance().total_count - plugin_.instance().largest_count;
  }
  // 1 for bodies, by number, that it does not count; empty: it counts all.
  const std::vector<std::uint8_t>& left_out() const { return left_out_; }
  const Parameters& parameters() const { return plugin_.parameters(); }
  // Of this probe alone in this process.
  std::uint64_t number() const { return number_; }

  // Updates the state. inputs: values of the columns of other probes that this one reads, in the order of
  // Parameters::inputs(). Throws Error, as sample() does, if the scene lacks what the probe reads.
  void observe(const scree_view& view, std::span<const double> inputs = {});
  // One row of values. totals: called once the probe has started, see Simulation::totals_of; empty: they are
  // added up over all bodies and contacts of the view.
  using Totals = std::function<std::vector<double>()>;
  std::vector<double> sample(const scree_view& view, std::span<const double> inputs = {},
                             const Totals& totals = {});
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
  // Throws Error if what the plug-in says of its totals does not fit together.
  void check_totals() const;
  // With all bodies and contacts of the view as one part.
  std::vector<double> totals_in(const scree_view& view) const;
  // The bodies that the plug-in marks, if these are not all.
  ListedBodies marked(const scree_view& view, const std::vector<double>& state) const;

  ConfiguredProbe plugin_;
  std::uint64_t number_;
  std::vector<std::string> names_, units_;
  std::vector<std::uint8_t> left_out_;
  std::vector<double> state_;  // with a guard behind the numbers of the state
  std::size_t state_size_ = 0;
  bool is_started_ = false, is_listed_ = false;
  ListedBodies listed_;
};

}  // namespace scree
