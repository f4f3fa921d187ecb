#include "output_keys.hpp"
#include "probe_drafts.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/formula/units.hpp>

namespace scree::scenario {

namespace {

constexpr const char* derived_name = "derived";  // of the table, the probe and its series

Error error_at(const DerivedQuantity& quantity, std::size_t at, const std::string& problem,
               const std::string& cure) {
  return quantity.table.error_in_string(quantity.key, at, problem, cure);
}

// Calls read() and gives what is wrong with the formula its place.
template <class Read>
auto in_formula(const document::Table& table, const std::string& key, const Read& read) {
  try {
    return read();
  } catch (const formula::FormulaError& error) {
    throw table.error_in_string(key, error.at, error.problem(), error.cure());
  }
}

void check_quantity_name(const document::Table& t, const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_' || c >= 0x80; };
  if (name.empty() || name.size() >= SCREE_MAX_NAME || std::isdigit((unsigned char)name[0]) ||
      !std::all_of(name.begin(), name.end(), fits))
    throw t.error(
        name, fmt::format("'{}' cannot name a derived quantity", files::one_line(name)),
        fmt::format("begin with a letter, and use less than {} letters, digits and '_'", SCREE_MAX_NAME));
  if (name == "time" || name == "stage")
    throw t.error(name, fmt::format("every series has a column '{}' already", name), "give another name");
}

DerivedQuantity read_quantity(const document::Table& t, const std::string& name) {
  check_quantity_name(t, name);
  const bool in_table = t.is_table(name);
  const document::Table table = in_table ? t.table(name) : t;
  const std::string key = in_table ? derived_keys.formula.name : name;
  const std::string text = table.string(key);
  formula::Formula formula = in_formula(table, key, [&] { return formula::parse(text); });
  if (std::none_of(formula.names.begin(), formula.names.end(),
                   [](const formula::Name& column) { return column.text != "time"; }))
    throw table.error(key, fmt::format("the formula of '{}' reads no column", name),
                      "name one, as <probe>.<column>");
  return {name, table, key, std::move(formula)};
}

// As they are written in the resolved text: tables with headers of their own come last.
std::vector<std::string> quantity_keys(const document::Table& t) {
  std::vector<std::string> keys = t.keys();
  std::stable_partition(keys.begin(), keys.end(),
                        [&](const std::string& key) { return !t.is_table(key) || t.is_inline_table(key); });
  return keys;
}

// The slot of "derived.<column>" in the formula of quantity q.
std::size_t slot_of_quantity(const ProbeDraft& draft, std::size_t q, const std::string& column,
                             std::size_t at) {
  std::vector<std::string> names;
  for (const DerivedQuantity& quantity : draft.quantities) names.push_back(quantity.name);
  const auto found = std::size_t(std::find(names.begin(), names.end(), column) - names.begin());
  const DerivedQuantity& reader = draft.quantities[q];
  if (found == names.size())
    throw error_at(reader, at, fmt::format("no derived quantity '{}'", files::one_line(column)),
                   document::name_cure(column, names));
  if (found == q)
    throw error_at(reader, at, fmt::format("the quantity '{}' reads itself", column), "name another column");
  if (found > q)
    throw error_at(reader, at, fmt::format("'{}' reads '{}', which stands below it", names[q], column),
                   "exchange them");
  return found;
}

// The slot of a column of a probe, which becomes an input.
std::size_t slot_of_column(ProbeDraft& draft, const InputKey& input) {
  const auto same = [&](const InputKey& other) {
    return other.probe == input.probe && other.column == input.column;
  };
  const auto found = std::find_if(draft.inputs.begin(), draft.inputs.end(), same);
  const auto index = std::size_t(found - draft.inputs.begin());
  if (found == draft.inputs.end()) draft.inputs.push_back(input);
  return draft.quantities.size() + 1 + index;  // behind the slots of quantities and of the time
}

void find_names(ProbeDraft& draft, std::size_t q, const std::vector<std::string>& probes) {
  DerivedQuantity& quantity = draft.quantities[q];
  const auto reads = [&](std::size_t probe) {
    if (std::find(quantity.probes.begin(), quantity.probes.end(), probe) == quantity.probes.end())
      quantity.probes.push_back(probe);
  };
  for (const formula::Name& name : quantity.formula.names) {
    const std::size_t dot = name.text.find('.');
    if (dot == name.text.npos) {  // time
      quantity.slots.push_back(draft.quantities.size());
      continue;
    }
    const std::string probe = name.text.substr(0, dot), column = name.text.substr(dot + 1);
    if (probe == derived_name) {
      quantity.slots.push_back(slot_of_quantity(draft, q, column, name.at));
      for (const std::size_t p : draft.quantities[quantity.slots.back()].probes) reads(p);
      continue;
    }
    const auto number = std::size_t(std::find(probes.begin(), probes.end(), probe) - probes.begin());
    if (number == probes.size())
      throw error_at(quantity, name.at, fmt::format("no probe '{}'", files::one_line(probe)),
                     document::name_cure(probe, probes));
    quantity.slots.push_back(slot_of_column(draft, {quantity.name, column, number}));
    reads(number);
  }
}

// The unit of each name of a quantity; refuses columns that their probes do not have.
std::vector<std::string> units_of_names(const ProbeDraft& draft, const DerivedQuantity& quantity,
                                        const std::vector<ProbeDraft>& drafts, int dimension) {
  const std::size_t of_time = draft.quantities.size();
  std::vector<std::string> units;
  for (std::size_t k = 0; k < quantity.slots.size(); ++k) {
    const std::size_t slot = quantity.slots[k];
    if (slot <= of_time) {
      units.push_back(slot < of_time ? draft.quantities[slot].unit : "s");
      continue;
    }
    const formula::Name& name = quantity.formula.names[k];
    const InputKey& input = draft.inputs[slot - of_time - 1];
    const ProbePlan& read = drafts[input.probe].plan;
    const Probe probe = configured(read, dimension);
    const std::vector<std::string> columns = probe.names();
    const auto found = std::find(columns.begin(), columns.end(), input.column);
    if (found == columns.end())
      throw error_at(
          quantity, name.at,
          fmt::format("'{}' is no column of the probe '{}'", files::one_line(name.text), read.name),
          input.column == "time" ? "write time alone" : document::name_cure(input.column, columns));
    units.push_back(probe.units()[std::size_t(found - columns.begin())]);
  }
  return units;
}

// In whose formula it stands, or as the user has given it.
std::string unit_of_quantity(const DerivedQuantity& quantity, const std::vector<std::string>& of_names) {
  const document::Table& t = quantity.table;
  if (quantity.key != derived_keys.formula.name || !t.optional(derived_keys.unit))
    return in_formula(t, quantity.key, [&] { return formula::unit_of(quantity.formula, of_names); });
  const std::string unit = t.string(derived_keys.unit);
  const auto fits = [](unsigned char c) {
    return c >= 0x20 && c != 0x7f && std::string_view(",\"[]").find(char(c)) == std::string_view::npos;
  };
  if (unit.size() >= SCREE_MAX_NAME || !std::all_of(unit.begin(), unit.end(), fits))
    throw t.error(derived_keys.unit,
                  fmt::format("'{}' cannot stand in the header of a series", files::one_line(unit)),
                  fmt::format("use less than {} bytes, without commas, quotes and brackets", SCREE_MAX_NAME));
  return unit == "1" ? "" : unit;
}

double every_of(const DerivedQuantity& quantity, const std::vector<ProbeDraft>& drafts, double step) {
  if (quantity.key == derived_keys.formula.name && quantity.table.optional(derived_keys.every))
    return read_interval(quantity.table, derived_keys.every, step);
  double every = drafts[quantity.probes.front()].plan.every;
  for (const std::size_t p : quantity.probes) every = std::max(every, drafts[p].plan.every);
  return every;
}

// Stages in which all probes record that a quantity reads.
std::vector<std::string> common_stages(const DerivedQuantity& quantity, const std::vector<ProbeDraft>& drafts,
                                       const std::vector<std::string>& all) {
  std::vector<std::string> common;
  for (const std::string& stage : all)
    if (std::all_of(quantity.probes.begin(), quantity.probes.end(), [&](std::size_t p) {
          const std::vector<std::string>& stages = drafts[p].plan.stages;
          return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
        }))
      common.push_back(stage);
  if (common.empty() && !all.empty())
    throw quantity.table.error(
        quantity.key, fmt::format("the probes that '{}' reads record in no stage together", quantity.name),
        "give them a stage in common");
  return common.size() == all.size() ? std::vector<std::string>() : common;
}

// In any of the stages of its columns.
void set_stages(const std::vector<std::string>& all, ProbePlan& plan) {
  const auto& columns = plan.stages_of_columns;
  for (const std::string& stage : all)
    if (std::any_of(columns.begin(), columns.end(), [&](const std::vector<std::string>& stages) {
          return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
        }))
      plan.stages.push_back(stage);
  if (plan.stages.size() == all.size()) plan.stages.clear();
}

}  // namespace

std::optional<ProbeDraft> read_derived(const document::Table& root) {
  const auto t = root.optional_table(derived_name);
  if (!t) return std::nullopt;
  ProbePlan plan{
      .name = derived_name, .parameters = Parameters(derived_plugin()), .stages = {}, .place = t->place()};
  ProbeDraft draft = {*t, std::move(plan)};
  for (const std::string& name : quantity_keys(*t)) draft.quantities.push_back(read_quantity(*t, name));
  if (draft.quantities.empty())
    throw t->error("the table [derived] has no quantity",
                   "give some, as K0 = \"box.stress_xx / box.stress_zz\", or remove it");
  return draft;
}

void find_derived_inputs(ProbeDraft& draft, const std::vector<std::string>& names) {
  for (std::size_t q = 0; q < draft.quantities.size(); ++q) find_names(draft, q, names);
}

void read_derived_probe(ProbeDraft& draft, const std::vector<ProbeDraft>& drafts, const Scene& scene,
                        const std::vector<std::string>& stages) {
  ProbePlan& plan = draft.plan;
  for (DerivedQuantity& quantity : draft.quantities) {
    quantity.unit = unit_of_quantity(quantity, units_of_names(draft, quantity, drafts, scene.dimension));
    const double every = every_of(quantity, drafts, scene.step);
    plan.every = plan.every > 0 ? std::min(plan.every, every) : every;
    plan.stages_of_columns.push_back(common_stages(quantity, drafts, stages));
  }
  set_stages(stages, plan);
  for (const InputKey& input : draft.inputs) {
    const ProbePlan& read = drafts[input.probe].plan;
    const std::vector<std::string> columns = configured(read, scene.dimension).names();
    const auto column = std::find(columns.begin(), columns.end(), input.column) - columns.begin();
    plan.inputs.push_back({input.probe, std::size_t(column)});
    plan.depth = std::max(plan.depth, read.depth + 1);
  }
  set_quantities(draft.quantities, plan.parameters);
}

}  // namespace scree::scenario
