#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <numbers>

#include <scree/nearest.hpp>

#include "verbs.hpp"

namespace scree::tool {

namespace {

struct DescribeArguments {
  std::string name;
  std::vector<std::string> values;
  int dimension = 3;
  double radius = 0.005, density = 2000, speed = 1;
  PluginOptions plugins;
};

void list_all(PluginHost& host) {
  std::vector<PluginHost::Broken> broken;
  const auto plugins = host.load_all(broken);
  for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_TERM, SCREE_PROBE}) {
    static constexpr const char* tables[] = {"", "contact", "boundary", "body_force", "probe"};
    fmt::print("{}s, [[{}]]\n", kind_name(kind), tables[kind]);
    for (const scree_plugin* plugin : plugins)
      if (plugin->kind == std::uint32_t(kind)) fmt::print("  {:<24} {}\n", plugin->name, plugin->summary);
  }
  for (const PluginHost::Broken& b : broken) fmt::print("cannot be used: {}\n", b.reason);
  fmt::print("\nscree describe NAME tells the equations and parameters of one of them.\n");
}

void print_parameters(const scree_plugin& plugin) {
  fmt::print("\nparameters\n");
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    std::string initial;
    if (p.excludes)
      initial = fmt::format("this or {}", p.excludes);
    else if (p.flags & SCREE_REQUIRED)
      initial = "required";
    else if (p.flags & SCREE_OPTIONAL)
      initial = "optional";
    else if (p.type == SCREE_CHOICE)
      initial = "default " + choices_of(p)[std::size_t(p.default_value)];
    else
      initial = fmt::format("default {:g}", p.default_value);
    fmt::print("  {:<22} {}; {}\n  {:<22} {}\n", p.key, describe_range(p), initial, "", p.doc);
  }
  if (plugin.parameter_count == 0) fmt::print("  none\n");
}

void set_value(Parameters& parameters, const std::string& text) {
  const auto equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const scree_parameter* p = parameters.find(key);
  if (!p || equals == std::string::npos) {
    std::vector<std::string> keys;
    for (std::uint32_t k = 0; k < parameters.plugin().parameter_count; ++k) keys.push_back(parameters.plugin().parameters[k].key);
    const auto near = nearest_word(key, keys);
    throw Error(fmt::format("'{}': give KEY=VALUE with a parameter of {}{}", text, parameters.plugin().name,
                            near ? fmt::format("; did you mean '{}'?", *near) : ""));
  }
  const std::string word = text.substr(equals + 1);
  if (p->type == SCREE_CHOICE) {
    const auto words = choices_of(*p);
    for (std::size_t k = 0; k < words.size(); ++k)
      if (words[k] == word) return parameters.set(key, {double(k)});
    throw Error(fmt::format("'{}': give one of {}", text, fmt::join(words, ", ")));
  }
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end) throw Error(fmt::format("'{}': '{}' is no number", text, word));
  parameters.set(key, {value});
}

void print_closed_forms(const scree_plugin& plugin, const DescribeArguments& a) {
  Parameters parameters(plugin);
  for (const std::string& value : a.values) set_value(parameters, value);
  if (a.values.empty()) {
    fmt::print("\nGive parameters as KEY=VALUE to see contact time, restitution and critical step.\n");
    return;
  }
  constexpr double nowhere[3] = {0, 0, 0};
  const ConfiguredLaw law(parameters, a.dimension, nowhere, nowhere);
  const double r = a.radius;
  const double mass = a.density * (a.dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r);
  scree_closed_form forms[16];
  const auto show = [&](const char* who, double reduced_mass, double effective_radius) {
    const scree_encounter encounter = {reduced_mass, effective_radius, a.speed};
    const std::uint32_t n = law.interface().closed_forms(law.storage(), &encounter, forms, 16);
    fmt::print("\n{} (m* = {:.6g} kg, R* = {:g} m, {:g} m/s)\n", who, reduced_mass, effective_radius, a.speed);
    for (std::uint32_t k = 0; k < n; ++k)
      fmt::print("  {:<16} {:<14} {}\n", forms[k].name, fmt::format("{:.6g} {}", forms[k].value, forms[k].unit), forms[k].formula);
  };
  show(fmt::format("two equal {}, R = {:g} m, density {:g} kg/m^3", a.dimension == 2 ? "discs" : "spheres", r, a.density).c_str(), mass / 2, r / 2);
  show("one of them and a wall", mass, r);
}

const scree_plugin& find_any(PluginHost& host, const std::string& name) {
  std::vector<std::string> all;
  for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_TERM, SCREE_PROBE})
    for (const std::string& known : host.names(kind)) {
      // "probe/box" tells the kinds apart where a name stands for several.
      if (known == name || name == std::string(kind_folder(kind)) + "/" + known) return host.find(known, kind);
      all.push_back(known);
    }
  const auto near = nearest_word(name, all);
  throw Error(near ? fmt::format("no plug-in '{}'; did you mean '{}'?", name, *near) : fmt::format("no plug-in '{}'; see scree describe", name));
}

void describe_one(const scree_plugin& plugin, const DescribeArguments& arguments) {
  fmt::print("{}, {}: {}\n{}\n\nequations\n", plugin.name, kind_name(scree_kind(plugin.kind)), plugin.summary, plugin.source);
  for (const char* c = plugin.equation, *line = c;; ++c)
    if (*c == '\n' || !*c) {
      fmt::print("  {}\n", std::string(line, c));
      if (!*c) break;
      line = c + 1;
    }
  print_parameters(plugin);
  if (plugin.kind == SCREE_CONTACT_LAW) print_closed_forms(plugin, arguments);
}

ExitStatus describe(const DescribeArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  if (arguments.name.empty())
    list_all(host);
  else
    describe_one(find_any(host, arguments.name), arguments);
  return ExitStatus::success;
}

}  // namespace

void add_describe_verb(CLI::App& app, ExitStatus& status) {
  CLI::App* verb = app.add_subcommand("describe", "List plug-ins, or tell one's equations, parameters and closed forms");
  auto a = std::make_shared<DescribeArguments>();
  verb->add_option("name", a->name, "Plug-in; kind/name where two kinds share a name, as boundary/box and probe/box");
  verb->add_option("values", a->values, "Parameters as KEY=VALUE, for the closed forms")->type_name("KEY=VALUE");
  verb->add_option("--dimension", a->dimension, "2 or 3 (default 3)")->check(CLI::Range(2, 3));
  verb->add_option("--radius", a->radius, "Radius of the bodies, m (default 0.005)")->check(CLI::PositiveNumber);
  verb->add_option("--density", a->density, "Density, kg/m^3 (default 2000)")->check(CLI::PositiveNumber);
  verb->add_option("--speed", a->speed, "Impact speed, m/s (default 1)")->check(CLI::PositiveNumber);
  add_plugin_options(*verb, a->plugins);
  verb->footer("Example: scree describe linear_spring_dashpot normal_stiffness=5000 normal_damping=0.05 --radius 0.005");
  verb->callback([a, &status] { status = describe(*a); });
}

}  // namespace scree::tool
