#include "observer.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::spectrum {

Observer::Observer(const scenario::Plan& plan, std::vector<ObservedColumn> observed)
    : plan_(plan), observed_(std::move(observed)), values_(observed_.size()) {
  for (const ObservedColumn& column : observed_) watch(column.probe);
}

Observer::Watched& Observer::watched(std::size_t probe) {
  return *std::find_if(probes_.begin(), probes_.end(), [&](const Watched& w) { return w.number == probe; });
}

void Observer::watch(std::size_t probe) {
  if (std::any_of(probes_.begin(), probes_.end(), [&](const Watched& w) { return w.number == probe; }))
    return;
  const scenario::ProbePlan& plan = plan_.probes[probe];
  for (const scenario::ProbeInput& input : plan.inputs) watch(input.probe);
  probes_.push_back({probe, scenario::configured(plan, plan_.scene.dimension), {}});
}

std::uint32_t Observer::needs() const {
  std::uint32_t needs = SCREE_NEEDS_NO_BODIES;
  for (const Watched& watched : probes_) needs = joint_needs(needs, watched.probe.needs());
  return needs;
}

const std::vector<double>& Observer::values(const scree_view& view) {
  for (Watched& watched : probes_) {
    const scenario::ProbePlan& plan = plan_.probes[watched.number];
    std::vector<double> inputs;
    for (const scenario::ProbeInput& input : plan.inputs)
      inputs.push_back(this->watched(input.probe).row[input.column]);
    try {
      watched.row = watched.probe.sample(view, inputs);
    } catch (const Error& error) {
      throw error.at(plan.place);
    }
    for (std::size_t c = 0; c < values_.size(); ++c)
      if (const ObservedColumn& column = observed_[c]; column.probe == watched.number)
        values_[c] = watched.row[column.column];
  }
  return values_;
}

const std::vector<double>& Observer::values(const Simulation& simulation) {
  return values(SimulationView(simulation, needs()).get());
}

void check_observed(const scenario::Plan& plan, const std::vector<ObservedColumn>& observed,
                    const Simulation& simulation) {
  Observer observer(plan, observed);
  const std::vector<double>& values = observer.values(simulation);
  for (std::size_t c = 0; c < values.size(); ++c) {
    const ObservedColumn& column = observed[c];
    if (!std::isfinite(values[c]))
      throw Error(fmt::format("{}: '{}' has no value at the start; observe a column that has one",
                              column.place, column.name));
    if (column.relative && values[c] == 0)
      throw Error(
          fmt::format("{}: '{}' is 0 at the start, so that nothing is relative to it; leave it out of "
                      "relative_to_mean",
                      column.place, column.name));
  }
}

void Observer::transfer(const StateTransfer& state) {
  for (std::size_t k = 0; k < probes_.size(); ++k) probes_[k].probe.transfer(state.below(std::to_string(k)));
}

void Observer::check_restored(const Simulation& simulation) const {
  const SimulationView view(simulation, needs());
  for (const Watched& watched : probes_) watched.probe.check_restored(view.get());
}

}  // namespace scree::spectrum
