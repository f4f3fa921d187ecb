#include "observer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::sound {

Observer::Observer(const scenario::Plan& plan) : plan_(plan), values_(plan.spectrum->observed.size()) {
  for (const scenario::ObservedColumn& column : plan.spectrum->observed)
    if (std::none_of(probes_.begin(), probes_.end(),
                     [&](const Watched& w) { return w.number == column.probe; }))
      probes_.push_back({column.probe, Probe(plan.probes[column.probe].parameters, plan.scene.dimension)});
}

std::uint32_t Observer::needs() const {
  std::uint32_t needs = 0;
  for (const Watched& watched : probes_) needs |= watched.probe.needs();
  return needs;
}

const std::vector<double>& Observer::values(const scree_view& view) {
  for (Watched& watched : probes_) {
    const std::vector<double> row = [&] {
      try {
        return watched.probe.sample(view);
      } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", plan_.probes[watched.number].place, error.what()), error.status());
      }
    }();
    for (std::size_t c = 0; c < values_.size(); ++c)
      if (const scenario::ObservedColumn& column = plan_.spectrum->observed[c];
          column.probe == watched.number)
        values_[c] = row[column.column];
  }
  return values_;
}

const std::vector<double>& Observer::values(const Simulation& simulation) {
  return values(SimulationView(simulation, needs()).get());
}

void Observer::transfer(const StateTransfer& state) {
  for (std::size_t k = 0; k < probes_.size(); ++k) probes_[k].probe.transfer(state.below(std::to_string(k)));
}

}  // namespace scree::sound
