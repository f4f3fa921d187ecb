#include "output_keys.hpp"
#include "probe_drafts.hpp"
#include "readers.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/files/text.hpp>
#include <scree/probes.hpp>

namespace scree::scenario {

namespace {

ProbeDraft read_name(const document::Table& t, PluginHost& host) {
  ProbePlan plan{.name = "",
                 .parameters = Parameters(find_plugin(t, SCREE_PROBE, host)),
                 .stages = {},
                 .place = t.place("plugin")};
  plan.name = t.string(probe_keys.name, plan.parameters.plugin().name);
  check_file_name(t, plan.name);
  return {t, std::move(plan)};
}

InputKey read_input(const ProbeDraft& draft, const std::string& key, const std::vector<std::string>& names) {
  const document::Table& t = draft.table;
  const std::string text = t.string(key);
  const std::size_t dot = text.find('.');
  if (dot == text.npos)
    throw t.error(key, fmt::format("'{}' is not <probe>.<column>", files::one_line(text)),
                  "give the name of a [[probe]], a dot and one of its columns");
  const std::size_t probe = find_name(t, key, "probe", text.substr(0, dot), names);
  if (names[probe] == draft.plan.name)
    throw t.error(key, fmt::format("the probe '{}' reads a column of itself", draft.plan.name),
                  "give a column of another probe");
  return {key, text.substr(dot + 1), probe};
}

void find_inputs(ProbeDraft& draft, const std::vector<std::string>& names) {
  if (!draft.quantities.empty()) return find_derived_inputs(draft, names);
  const scree_plugin& plugin = draft.plan.parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k)
    if (const scree_parameter& p = plugin.parameters[k]; p.type == SCREE_INPUT && draft.table.optional(p.key))
      draft.inputs.push_back(read_input(draft, p.key, names));
}

// Refuses probes that wait for each other. waits: whether a draft is one of them, or reads from one.
[[noreturn]] void refuse_cycle(const std::vector<ProbeDraft>& drafts, const std::vector<bool>& waits) {
  const auto next = [&](std::size_t k) {
    return *std::find_if(drafts[k].inputs.begin(), drafts[k].inputs.end(),
                         [&](const InputKey& input) { return waits[input.probe]; });
  };
  std::vector<std::size_t> path;
  auto k = std::size_t(std::find(waits.begin(), waits.end(), true) - waits.begin());
  for (; std::find(path.begin(), path.end(), k) == path.end(); k = next(k).probe) path.push_back(k);
  std::vector<std::string> names;
  for (auto at = std::find(path.begin(), path.end(), k); at != path.end(); ++at)
    names.push_back(drafts[*at].plan.name);
  throw drafts[k].table.error(
      next(k).key,
      fmt::format("the probes {} read columns of each other in a circle", fmt::join(names, ", ")),
      "let one of them read a column of another probe");
}

// Indices of the drafts, each after the drafts whose columns it reads.
std::vector<std::size_t> reading_order(const std::vector<ProbeDraft>& drafts) {
  std::vector<std::size_t> order;
  std::vector<bool> waits(drafts.size(), true);
  while (order.size() < drafts.size()) {
    const std::size_t before = order.size();
    for (std::size_t k = 0; k < drafts.size(); ++k) {
      const auto ready = [&](const InputKey& input) { return !waits[input.probe]; };
      if (!waits[k] || !std::all_of(drafts[k].inputs.begin(), drafts[k].inputs.end(), ready)) continue;
      order.push_back(k);
      waits[k] = false;
    }
    if (order.size() == before) refuse_cycle(drafts, waits);
  }
  return order;
}

// A column has a value only while its probe records.
void check_stages(const ProbeDraft& reader, const InputKey& input, const ProbePlan& read, std::size_t column,
                  const std::vector<std::string>& all) {
  const std::vector<std::string>& stages = reader.plan.stages.empty() ? all : reader.plan.stages;
  const std::vector<std::string>& recorded = read.stages_of(column);
  for (const std::string& stage : stages)
    if (!recorded.empty() && std::find(recorded.begin(), recorded.end(), stage) == recorded.end())
      throw reader.table.error(input.key,
                               fmt::format("the probe '{}' does not record in stage '{}', in which '{}' does",
                                           read.name, files::one_line(stage), reader.plan.name),
                               "give both the same stages");
}

void take_inputs(ProbeDraft& draft, const std::vector<ProbeDraft>& drafts, int dimension,
                 const std::vector<std::string>& stages) {
  for (const InputKey& input : draft.inputs) {
    const ProbePlan& read = drafts[input.probe].plan;
    const Probe read_from = configured(read, dimension);
    const std::size_t column = find_name(draft.table, input.key, "column", input.column, read_from.names());
    check_stages(draft, input, read, column, stages);
    draft.plan.parameters.set_input(input.key, read.name + "." + input.column, read_from.units()[column]);
    draft.plan.inputs.push_back({input.probe, column});
    draft.plan.depth = std::max(draft.plan.depth, read.depth + 1);
  }
}

void check_selection(const document::Table& t, const Probe& probe, const ProbePlan& plan) {
  if (!plan.left_out.empty() && !probe.leaves_out())
    throw t.error(t.optional(probe_keys.groups) ? probe_keys.groups : probe_keys.leave_out,
                  fmt::format("the probe {} does not choose between bodies", plan.parameters.plugin().name),
                  "remove groups and leave_out");
}

void read_observation(const document::Table& t, const Probe& probe, const Scene& scene, ProbePlan& plan) {
  const char* const plugin = plan.parameters.plugin().name;
  if (!t.optional(probe_keys.observe_every)) {
    if (probe.observe_every() > scene.step) plan.observe_every = probe.observe_every();
    return;
  }
  if (!probe.observes())
    throw t.error(probe_keys.observe_every,
                  fmt::format("the probe {} does not observe the run with these parameters", plugin),
                  "remove observe_every");
  if (probe.observe_every() > 0)
    throw t.error(probe_keys.observe_every, fmt::format("the probe {} has times of its own", plugin),
                  "remove observe_every");
  plan.observe_every = read_interval(t, probe_keys.observe_every, scene.step);
}

void read_probe(ProbeDraft& draft, const std::vector<ProbeDraft>& drafts, const Scene& scene,
                const std::vector<std::string>& stages) {
  if (!draft.quantities.empty()) return read_derived_probe(draft, drafts, scene, stages);
  const document::Table& t = draft.table;
  ProbePlan& plan = draft.plan;
  const ListReader read_list = [&](const document::Table& table, const char* key) {
    return read_numbers_or_walls(table, key, scene);
  };
  read_parameters(t, scene.dimension, no_mesh, plan.parameters, read_list);
  plan.left_out = read_left_out(t, scene);
  // Without stages there is no run, and no time between samples.
  if (!stages.empty() || t.optional(probe_keys.every))
    plan.every = read_interval(t, probe_keys.every, scene.step);
  plan.stages = read_stage_names(t, stages);
  take_inputs(draft, drafts, scene.dimension, stages);
  check_complete(t, plan.parameters);
  const Probe probe = placed(t, "plugin", [&] { return Probe(plan.parameters, scene.dimension); });
  check_selection(t, probe, plan);
  read_observation(t, probe, scene, plan);
}

}  // namespace

Probe configured(const ProbePlan& probe, int dimension) {
  return Probe(probe.parameters, dimension, probe.left_out);
}

ProbeColumns columns_of(const ProbePlan& probe, int dimension) {
  const Probe described = configured(probe, dimension);
  ProbeColumns columns = {probe.name, described.names(), described.units()};
  columns.names.insert(columns.names.begin(), "time");
  columns.units.insert(columns.units.begin(), "s");
  return columns;
}

std::vector<ProbePlan> read_probes(const document::Table& root, const Scene& scene,
                                   const std::vector<Stage>& stages, PluginHost& host) {
  std::vector<ProbeDraft> drafts;
  UniqueNames unique("probe");
  std::vector<std::string> names, stage_names;
  for (const Stage& stage : stages) stage_names.push_back(stage.name);
  for (const document::Table& t : root.tables("probe")) {
    drafts.push_back(read_name(t, host));
    names.push_back(drafts.back().plan.name);
    unique.add(t, names.back());
  }
  if (auto derived = read_derived(root)) {
    const std::string& name = derived->plan.name;
    if (const auto same = std::find(names.begin(), names.end(), name); same != names.end())
      throw drafts[std::size_t(same - names.begin())].table.error(
          "name", fmt::format("the probe has the name '{}' of the series of [derived]", name),
          "give it another name");
    names.push_back(name);
    drafts.push_back(std::move(*derived));
  }
  for (ProbeDraft& draft : drafts) find_inputs(draft, names);
  for (const std::size_t k : reading_order(drafts)) read_probe(drafts[k], drafts, scene, stage_names);
  std::vector<ProbePlan> probes;
  for (ProbeDraft& draft : drafts) probes.push_back(std::move(draft.plan));
  return probes;
}

}  // namespace scree::scenario
