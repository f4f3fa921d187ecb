#include "sampler.hpp"

#include <algorithm>
#include <cmath>

namespace scree::scenario {

std::uint64_t steps_in(double duration, double step) {
  constexpr double most = 1e18;  // fits the integer
  return std::uint64_t(std::llround(std::clamp(duration / step, 1.0, most)));
}

Sampler::Sampler(const Plan& plan, double step) {
  for (const ProbePlan& probe : plan.probes)
    probes_.push_back({&probe, Probe(probe.parameters, plan.scene.dimension), steps_in(probe.every, step)});
}

void Sampler::open(const std::filesystem::path& folder) {
  for (Active& p : probes_)
    p.series = std::make_unique<Series>(folder / (p.plan->name + ".csv"), p.probe.names(), p.probe.units());
}

bool Sampler::Active::due(const std::string& stage, std::uint64_t steps) const {
  const std::vector<std::string>& stages = plan->stages;
  return steps % interval == 0 &&
         (stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end());
}

void Sampler::sample(const Simulation& simulation, const std::string& stage, std::uint64_t steps) {
  bool contacts = false, any = false;
  for (const Active& p : probes_)
    if (p.due(stage, steps)) any = true, contacts |= p.probe.needs_contacts();
  if (!any) return;
  const SimulationView view(simulation, contacts);
  for (Active& p : probes_) {
    if (!p.due(stage, steps)) continue;
    // The last row of a stage is the first of the next.
    if (p.series->rows() > 0 && p.series->column("time").back() == simulation.time()) continue;
    p.series->add(simulation.time(), p.probe.sample(view.get()));
  }
}

void Sampler::flush() {
  for (Active& p : probes_) p.series->flush();
}

const Series& Sampler::series(const std::string& probe) const {
  return *std::find_if(probes_.begin(), probes_.end(), [&](const Active& p) {
            return p.plan->name == probe;
          })->series;
}

}  // namespace scree::scenario
