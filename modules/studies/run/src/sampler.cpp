#include "sampler.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include <scree/document/message.hpp>

namespace scree::run {

bool is_due(std::uint64_t steps, double every, double step) {
  return steps == 0 || next_due(steps - 1, every, step) == steps;
}

std::uint64_t next_due(std::uint64_t steps, double every, double step) {
  // Starts one multiple early, for rounding.
  double multiple = std::max(0.0, std::floor((double(steps) + 0.5) * step / every) - 1);
  // Every count that a run reaches is below 2^53, and so is the multiple unless a state claims more.
  while (multiple < 0x1p53 && std::round(multiple * every / step) <= double(steps)) ++multiple;
  const double next = std::round(multiple * every / step);
  return next < 0x1p53 && next > double(steps) ? std::uint64_t(next) : never;
}

Sampler::Sampler(const scenario::Plan& plan)
    : staged_(plan.stages.size() > 1), end_time_(duration_of(plan.stages)) {
  for (const scenario::ProbePlan& probe : plan.probes)
    probes_.push_back({&probe, scenario::configured(probe, plan.scene.dimension)});
  put_in_order();
}

void Sampler::put_in_order() {
  order_.resize(probes_.size());
  std::iota(order_.begin(), order_.end(), std::size_t(0));
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return probes_[a].plan->depth < probes_[b].plan->depth;
  });
}

void Sampler::add_needs(const Active& p, Shown& shown) const {
  shown.any = true;
  shown.needs = joint_needs(shown.needs, p.probe.view_needs());
  for (const scenario::ProbeInput& input : p.plan->inputs) add_needs(probes_[input.probe], shown);
  if ((p.probe.view_needs() & SCREE_NEEDS_NO_BODIES) || !shown.bodies) return;
  const ListedBodies& listed = p.probe.listed_bodies();
  if (!listed) return shown.bodies.reset();
  ListedBodies both(std::in_place);
  std::set_union(shown.bodies->begin(), shown.bodies->end(), listed->begin(), listed->end(),
                 std::back_inserter(*both));
  shown.bodies = std::move(both);
}

void Sampler::open(const std::filesystem::path& folder) {
  for (Active& p : probes_)
    p.series =
        std::make_unique<Series>(folder / (p.plan->name + ".csv"), p.probe.names(), p.probe.units(), staged_);
}

void Sampler::open() {
  for (Active& p : probes_) p.series = std::make_unique<Series>(p.probe.names());
}

bool Sampler::Active::records_in(const std::string& stage) const {
  const std::vector<std::string>& stages = plan->stages;
  return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
}

bool Sampler::Active::is_observed(const Simulation& s, std::uint64_t steps) const {
  if (!probe.observes() || observed == s.steps()) return false;
  return !plan->observe_every || is_due(steps, *plan->observe_every, s.step_length());
}

bool Sampler::Active::is_due_at(const Simulation& s, std::uint64_t steps) const {
  return is_due(steps, plan->every, s.step_length());
}

std::uint64_t Sampler::Active::next(double step, std::uint64_t steps) const {
  const std::uint64_t next_sample = next_due(steps, plan->every, step);
  if (!probe.observes()) return next_sample;
  return std::min(next_sample, plan->observe_every ? next_due(steps, *plan->observe_every, step) : steps + 1);
}

std::uint64_t Sampler::take(const Simulation& simulation, const std::string& stage, std::uint64_t steps) {
  // Conditions of stages and outputs ask at the same step.
  if (taken_step_ == simulation.steps() && taken_stage_ == stage) return next(simulation, stage, steps);
  taken_step_ = simulation.steps();
  taken_stage_ = stage;
  Shown shown;
  for (const Active& p : probes_)
    if (p.records_in(stage) && (p.is_observed(simulation, steps) || p.is_due_at(simulation, steps)))
      add_needs(p, shown);
  const std::uint64_t next = this->next(simulation, stage, steps);
  if (!shown.any) return next;
  const SimulationView shown_view(simulation, shown.needs, end_time_, shown.bodies);
  const Observed now = {simulation, shown_view.get(), stage};
  forget_rows();
  for (const std::size_t k : order_) {
    Active& p = probes_[k];
    if (!p.records_in(stage)) continue;
    if (p.is_observed(simulation, steps)) {
      p.probe.observe(now.view, inputs_of(p, now));
      p.observed = simulation.steps();
    }
    if (p.is_due_at(simulation, steps)) sample(p, now);
  }
  return next;
}

std::uint64_t Sampler::next(const Simulation& simulation, const std::string& stage,
                            std::uint64_t steps) const {
  std::uint64_t next = never;
  for (const Active& p : probes_)
    if (p.records_in(stage)) next = std::min(next, p.next(simulation.step_length(), steps));
  return next;
}

void Sampler::sample_last(const Simulation& simulation, const std::string& stage) {
  Shown shown;
  for (const Active& p : probes_)
    if (p.records_in(stage)) add_needs(p, shown);
  const SimulationView view(simulation, shown.needs, end_time_, shown.bodies);
  forget_rows();
  for (Active& p : probes_)
    if (p.records_in(stage)) sample(p, {simulation, view.get(), stage});
}

std::optional<double> Sampler::value(std::size_t probe, std::size_t column) const {
  const Active& p = probes_[probe];
  return p.sampled == taken_step_ && !p.row.empty() ? std::optional(p.row[column]) : std::nullopt;
}

void Sampler::sample(Active& p, const Observed& now) {
  p.sampled = now.view.step;
  if (!p.series) {
    row(p, now);
    return;
  }
  // The last row of a stage is also the first of the next stage.
  if (p.series->rows() > 0 && p.series->last_time() == now.view.time) return;
  const std::vector<double>& values = row(p, now);
  if (p.probe.observes()) p.last = values;
  p.series->add(now.view.time, values);
}

std::vector<std::string> Sampler::unfilled() const {
  std::vector<std::string> lines;
  for (const Active& p : probes_) {
    std::vector<std::string> names;
    for (std::size_t c = 0; p.probe.observes() && c < p.last.size(); ++c)
      if (std::isnan(p.last[c])) names.push_back(p.probe.names()[c]);
    if (names.empty()) continue;
    lines.push_back(fmt::format(
        "{}: the record of '{}' was not filled while it recorded, so that {} has no value at the end; give it "
        "an earlier or shorter record, or longer stages",
        p.plan->place, p.plan->name, document::listed(names)));
  }
  return lines;
}

const std::vector<double>& Sampler::row(Active& p, const Observed& now) {
  if (p.row.empty())
    p.row = p.probe.sample(now.view, inputs_of(p, now), [&] { return now.simulation.totals_of(p.probe); });
  return p.row;
}

void Sampler::forget_rows() {
  for (Active& p : probes_) p.row.clear();
}

std::vector<double> Sampler::inputs_of(const Active& p, const Observed& now) {
  std::vector<double> values;
  for (const scenario::ProbeInput& input : p.plan->inputs) {
    Active& read = probes_[input.probe];
    // A probe starts with the first stage in which it records.
    values.push_back(read.records_in(now.stage) ? row(read, now)[input.column]
                                                : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

void Sampler::begin_stage(std::size_t number) {
  for (Active& p : probes_) p.series->begin_stage(number);
}

void Sampler::flush() {
  for (Active& p : probes_) p.series->flush();
}

void Sampler::close() {
  for (Active& p : probes_) p.series.reset();
}

const Series& Sampler::series(const std::string& probe) const {
  return *std::find_if(probes_.begin(), probes_.end(), [&](const Active& p) {
            return p.plan->name == probe;
          })->series;
}

void Sampler::reopen(const std::filesystem::path& folder, std::size_t stage) {
  for (Active& p : probes_)
    p.series = std::make_unique<Series>(folder / (p.plan->name + ".csv"), p.probe.names(), staged_, p.end);
  begin_stage(stage);
}

void Sampler::check_restored(const Simulation& simulation) const {
  for (const Active& p : probes_) p.probe.check_restored(SimulationView(simulation, p.probe.needs()).get());
}

void Sampler::cut() {
  for (Active& p : probes_) p.series->cut();
}

void Sampler::transfer_probes(const StateTransfer& state) {
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    Active& p = probes_[k];
    const StateTransfer of_probe = state.below(std::to_string(k));
    if (!state.restoring() && p.series) p.end = {p.series->bytes(), p.series->rows(), p.series->last_time()};
    p.probe.transfer(of_probe);
    of_probe.value("observed", "1", p.observed);
    of_probe.value("bytes", "1", p.end.bytes);
    of_probe.value("rows", "1", p.end.rows);
    of_probe.value("last_time", "s", p.end.last_time);
  }
}

}  // namespace scree::run
