#include "describe_markdown.hpp"
#include "plugin_values.hpp"
#include "probe_columns.hpp"
#include "program_verbs.hpp"
#include "support/study_tables.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include <scree/closed_forms.hpp>
#include <scree/document/message.hpp>
#include <scree/scenario/keys.hpp>
#include <scree/state_file/description.hpp>

namespace scree::tool {

namespace {

constexpr scree_kind plugin_kinds[] = {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE, SCREE_PROBE};

struct DescribeArguments {
  std::string name;
  bool all = false;
  std::vector<std::string> values;
  int dimension = 0;  // 0: 3, or 2 for a law of discs
  double radius = 0.005, density = 2000, speed = 1;
  PluginOptions plugins;
};

void list_tables() {
  fmt::print("tables of a scenario\n");
  for (const scenario::TableDescription& table : scenario::describe_tables(study_tables()))
    fmt::print("  {:<24} {}\n", table.name, table.doc);
}

void list_all(PluginHost& host) {
  list_tables();
  std::vector<PluginHost::Broken> broken;
  const auto plugins = host.load_all(broken);
  for (const scree_kind kind : plugin_kinds) {
    static constexpr const char* title_of_kind[] = {"", "contact laws, [[contact]]",
                                                    "boundaries, [[boundary]]", "body forces, [[body_force]]",
                                                    "probes, [[probe]]"};
    fmt::print("{}\n", title_of_kind[kind]);
    for (const scree_plugin* plugin : plugins)
      if (plugin->kind == std::uint32_t(kind)) fmt::print("  {:<24} {}\n", plugin->name, plugin->summary);
  }
  for (const PluginHost::Broken& b : broken) fmt::print("not usable: {}\n", b.reason);
  fmt::print(
      "\nscree describe NAME shows the keys of a table, or the equations and parameters of a plug-in;\n"
      "scree describe --all prints all of them as Markdown.\n");
}

void print_parameters(const scree_plugin& plugin) {
  fmt::print("\nparameters\n");
  for (const ParameterLine& p : parameter_lines_of(plugin))
    fmt::print("  {:<22} {}; {}\n  {:<22} {}\n", p.keys, p.range, p.without, "", p.doc);
  if (plugin.parameter_count == 0) fmt::print("  none\n");
}

void print_table(const scenario::TableDescription& table) {
  fmt::print("{}, {}: {}\n\nkeys\n", table.name, table.header, table.doc);
  for (const scenario::KeyDescription& key : table.keys)
    fmt::print("  {:<22} {}; {}\n  {:<22} {}\n", key.name, key.value, key.absent, "", key.doc);
}

void print_columns(const std::vector<ColumnLine>& columns) {
  const auto head = [](const ColumnLine& c) { return fmt::format("{} [{}]", c.name, c.unit); };
  std::size_t widest = 0;
  for (const ColumnLine& c : columns) widest = std::max(widest, head(c).size());
  fmt::print("\ncolumns behind time [s]; <n>: a number that the parameters choose\n");
  for (const ColumnLine& c : columns) fmt::print("  {:<{}}  {}\n", head(c), widest, c.meaning);
}

// A law with the values of the command line, in their dimension or, where they have none, in one in which it
// exists; none without values.
std::optional<ConfiguredLaw> law_of(const scree_plugin& plugin, DescribeArguments& a) {
  if (a.values.empty()) return std::nullopt;
  if (plugin.kind != SCREE_CONTACT_LAW)
    throw Error(fmt::format("'{}': {} is a {} and has no closed forms; omit the value", a.values[0],
                            plugin.name, kind_name(scree_kind(plugin.kind))));
  Parameters parameters(plugin);
  for (const std::string& value : a.values) set_value(parameters, value);
  if (a.dimension == 0) a.dimension = dimensions_of(parameters).back();
  return ConfiguredLaw(parameters, a.dimension, no_bounds, no_bounds);
}

void print_forms(const std::string& who, const ConfiguredLaw& law, const scree_encounter& encounter) {
  fmt::print("\n{} (m* = {:.6g} kg, R* = {:g} m, {:g} m/s)\n", who, encounter.reduced_mass,
             encounter.effective_radius, encounter.speed);
  for (const scree_closed_form& form : closed_forms(law, encounter))
    fmt::print("  {:<16} {:<14} {}\n", form.name, fmt::format("{:.6g} {}", form.value, form.unit),
               form.formula);
}

void print_closed_forms(const ConfiguredLaw& law, const DescribeArguments& a) {
  const double r = a.radius, pi = std::numbers::pi;
  const double mass = a.density * (a.dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r);
  print_forms(fmt::format("two equal {}, R = {:g} m, density {:g} kg/m^{}",
                          a.dimension == 2 ? "discs" : "spheres", r, a.density, a.dimension),
              law, {mass / 2, r / 2, a.speed, 1});
  print_forms("one body and a wall", law, {mass, r, a.speed, 1});
}

std::optional<scenario::TableDescription> find_table(const std::string& name) {
  for (const scenario::TableDescription& table : scenario::describe_tables(study_tables()))
    if (name == table.name || name == table.header) return table;
  return std::nullopt;
}

// All plug-ins of a name; "probe/box" selects a kind where a name stands for several.
std::vector<const scree_plugin*> find_plugins(PluginHost& host, const std::string& name) {
  std::vector<const scree_plugin*> found;
  for (const scree_kind kind : plugin_kinds)
    for (const std::string& known : host.names(kind))
      if (known == name || name == std::string(kind_folder(kind)) + "/" + known)
        found.push_back(&host.find(known, kind));
  return found;
}

[[noreturn]] void refuse_name(const PluginHost& host, const std::string& name) {
  std::vector<std::string> all;
  for (const scenario::TableDescription& table : scenario::describe_tables(study_tables()))
    all.push_back(table.name);
  for (const scree_kind kind : plugin_kinds)
    for (const std::string& known : host.names(kind)) all.push_back(known);
  throw Error(fmt::format("no plug-in or table '{}'; {}", name, document::name_cure(name, all)));
}

void print_equation(const char* text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) fmt::print("  {}\n", line);
}

void describe_one(const scree_plugin& plugin, DescribeArguments arguments) {
  const auto law = law_of(plugin, arguments);  // first, so that a wrong value is all that is said
  fmt::print("{}, {}: {}\n{}\n\nequations\n", plugin.name, kind_name(scree_kind(plugin.kind)), plugin.summary,
             plugin.source);
  print_equation(plugin.equation);
  print_parameters(plugin);
  if (plugin.kind == SCREE_PROBE) print_columns(described_columns(Parameters(plugin)));
  if (law)
    print_closed_forms(*law, arguments);
  else if (plugin.kind == SCREE_CONTACT_LAW)
    fmt::print("\nGive parameters as KEY=VALUE to see contact time, restitution and critical step.\n");
}

// Whether a name is meant as that of a state file, which may be missing.
bool is_file(const std::string& name) {
  std::error_code failed;
  return name.ends_with(".h5") || std::filesystem::exists(name, failed);
}

ExitStatus describe(const DescribeArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  if (arguments.all) {
    print_markdown(host);
    return ExitStatus::success;
  }
  if (arguments.name.empty()) {
    list_all(host);
    return ExitStatus::success;
  }
  const auto table = find_table(arguments.name);
  const auto plugins = find_plugins(host, arguments.name);
  if (!table && plugins.empty() && is_file(arguments.name)) {
    fmt::print("{}", state_file::describe_state_file(arguments.name));
    return ExitStatus::success;
  }
  if (!table && plugins.empty()) refuse_name(host, arguments.name);
  if (table) print_table(*table);
  const char* gap = table ? "\n" : "";
  for (const scree_plugin* plugin : plugins) {
    fmt::print("{}", gap);
    describe_one(*plugin, arguments);
    gap = "\n";
  }
  for (const std::string& line : host.slow_laws()) report_warning(line);
  return ExitStatus::success;
}

}  // namespace

void add_describe_verb(CommandLine& line) {
  Verb verb = line.verb(
      "describe",
      "List tables and plug-ins, or show keys, equations, parameters and closed forms of one, or a state file");
  auto a = std::make_shared<DescribeArguments>();
  verb.option(
      "name", a->name,
      "Table or plug-in; kind/name where two kinds share a name, as boundary/box and probe/box; or a state file");
  verb.option("values", a->values, "Parameters as KEY=VALUE, for the closed forms").shown_as("KEY=VALUE");
  verb.flag("--all", a->all, "All tables and plug-ins as Markdown");
  verb.option("--dimension", a->dimension, "2 or 3 (default 3, for laws of discs 2)").between(2, 3);
  verb.option("--radius", a->radius, "Radius of the bodies, m (default 0.005)").above_zero();
  verb.option("--density", a->density, "Density, kg/m^3, of discs kg/m^2 (default 2000)").above_zero();
  verb.option("--speed", a->speed, "Impact speed, m/s (default 1)").above_zero();
  add_plugin_options(verb, a->plugins);
  verb.footer(
      "Example: scree describe linear_spring_dashpot normal_stiffness=5000 normal_damping=0.05 --radius "
      "0.005");
  verb.action([a] { return describe(*a); });
}

}  // namespace scree::tool
