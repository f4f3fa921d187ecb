#include "sampler.hpp"

#include <algorithm>
#include <cmath>

namespace scree::run {

bool is_due(std::uint64_t steps, double every, double step) {
  return steps == 0 || next_due(steps - 1, every, step) == steps;
}

std::uint64_t next_due(std::uint64_t steps, double every, double step) {
  // Starts one multiple early, for rounding.
  double multiple = std::max(0.0, std::floor((double(steps) + 0.5) * step / every) - 1);
  while (std::round(multiple * every / step) <= double(steps)) ++multiple;
  return std::uint64_t(std::round(multiple * every / step));
}

Sampler::Sampler(const scenario::Plan& plan) {
  for (const scenario::ProbePlan& probe : plan.probes)
    probes_.push_back({&probe, Probe(probe.parameters, plan.scene.dimension)});
}

void Sampler::open(const std::filesystem::path& folder) {
  for (Active& p : probes_)
    p.series = std::make_unique<Series>(folder / (p.plan->name + ".csv"), p.probe.names(), p.probe.units());
}

void Sampler::open() {
  for (Active& p : probes_) p.series = std::make_unique<Series>(p.probe.names());
}

bool Sampler::Active::samples_in(const std::string& stage) const {
  const std::vector<std::string>& stages = plan->stages;
  return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
}

std::uint64_t Sampler::sample(const Simulation& simulation, const std::string& stage, std::uint64_t steps) {
  const double step = simulation.step_length();
  sample_where(simulation,
               [&](const Active& p) { return is_due(steps, p.plan->every, step) && p.samples_in(stage); });
  std::uint64_t next = never;
  for (const Active& p : probes_)
    if (p.samples_in(stage)) next = std::min(next, next_due(steps, p.plan->every, step));
  return next;
}

void Sampler::sample_last(const Simulation& simulation, const std::string& stage) {
  sample_where(simulation, [&](const Active& p) { return p.samples_in(stage); });
}

template <class Due>
void Sampler::sample_where(const Simulation& simulation, const Due& due) {
  bool contacts = false, any = false;
  for (const Active& p : probes_)
    if (due(p)) any = true, contacts |= p.probe.needs_contacts();
  if (!any) return;
  const SimulationView view(simulation, contacts);
  for (Active& p : probes_) {
    if (!due(p)) continue;
    // The last row of a stage is also the first of the next stage.
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

}  // namespace scree::run
