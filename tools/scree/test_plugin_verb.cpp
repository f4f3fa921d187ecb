#include "plugin_values.hpp"
#include "program_verbs.hpp"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <scree/plugin_checks/law_checks.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;
using plugin_checks::Check;

struct TestPluginArguments {
  std::string file;
  std::vector<std::string> values;
  plugin_checks::CheckedPair pair;
};

// The folder of a plug-in's kind, <dir>/<kind>/<name>.so or <dir>/<kind>/<level>/<name>.so.
scree_kind kind_of(const fs::path& library) {
  for (const fs::path& folder : {library.parent_path(), library.parent_path().parent_path()})
    for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE, SCREE_PROBE})
      if (folder.filename() == kind_folder(kind)) return kind;
  throw Error(
      fmt::format("{}: does not lie in a folder contact, boundary, body_force or probe; "
                  "give the library where scree_add_plugin put it",
                  library.string()));
}

// A value for a parameter that must be given: typical for its unit, and within its range.
double typical_value(const scree_parameter& p) {
  const std::string unit = p.unit ? p.unit : "";
  double value = unit == "N/m" ? 5000 : unit == "Pa" ? 1e8 : 1;
  if (std::isfinite(p.minimum) && std::isfinite(p.maximum)) value = 0.5 * (p.minimum + p.maximum);
  return p.type == SCREE_CHOICE ? 0 : value;
}

// Fills in what is required and was not given. Returns what was chosen, as text.
std::string complete(Parameters& parameters) {
  std::string chosen;
  const scree_plugin& plugin = parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    const bool number = p.type == SCREE_NUMBER || p.type == SCREE_INTEGER || p.type == SCREE_CHOICE;
    const bool needed = (p.flags & SCREE_REQUIRED) || (p.excludes && !parameters.given(p.excludes));
    if (!number || !needed || parameters.given(p.key)) continue;
    parameters.set(p.key, {typical_value(p)});
    chosen += fmt::format("{}{} = {:g}", chosen.empty() ? "" : ", ", p.key, typical_value(p));
  }
  return chosen;
}

// Prints the checks. Returns whether none failed.
bool print(const plugin_checks::Checks& checks) {
  static constexpr const char* words[] = {"ok     ", "FAILED ", "skipped"};
  int count[3] = {};
  for (const Check& check : checks) {
    ++count[int(check.verdict)];
    fmt::print("{} {}: {}\n", words[int(check.verdict)], check.name, check.detail);
  }
  fmt::print("{} passed, {} failed, {} skipped\n", count[0], count[1], count[2]);
  return count[int(Check::Verdict::failed)] == 0;
}

ExitStatus test_plugin(const TestPluginArguments& a) {
  std::error_code failed;
  const fs::path library = fs::absolute(a.file, failed);
  if (!fs::is_regular_file(library, failed))
    throw Error(fmt::format("{}: no such library; give the path of a plug-in's .so", a.file));
  const scree_kind kind = kind_of(library);
  const bool at_level = library.parent_path().filename() != kind_folder(kind);
  const fs::path folder = at_level ? library.parent_path().parent_path() : library.parent_path();
  PluginHost host({folder.parent_path()});
  const scree_plugin& plugin = host.find(library.stem().string(), kind);
  fmt::print("{}, {}: {}\n", plugin.name, kind_name(kind), plugin.summary);
  if (kind != SCREE_CONTACT_LAW) {
    if (!a.values.empty())
      throw Error(fmt::format("'{}': values are for contact laws; omit them", a.values[0]));
    fmt::print(
        "ok      it loads, and its manifest and interface are those of this version\n"
        "General checks exist for contact laws; test a {} with a scene that has an [expect].\n",
        kind_name(kind));
    return ExitStatus::success;
  }
  Parameters parameters(plugin);
  for (const std::string& value : a.values) set_value(parameters, value);
  if (const std::string chosen = complete(parameters); !chosen.empty())
    fmt::print("not given, so chosen: {}\n", chosen);
  return print(plugin_checks::check_law(parameters, library, a.pair)) ? ExitStatus::success
                                                                      : ExitStatus::failure;
}

}  // namespace

void add_test_plugin_verb(CommandLine& line) {
  Verb verb = line.verb("test-plugin", "Check a plug-in library: what every contact law must satisfy");
  auto a = std::make_shared<TestPluginArguments>();
  verb.option("library", a->file, "The plug-in, <dir>/<kind>/<name>.so").required().shown_as("FILE");
  verb.option("values", a->values, "Parameters of a law as KEY=VALUE; required ones have typical values")
      .shown_as("KEY=VALUE");
  verb.option("--radius", a->pair.radius, "Radius of the smaller body, m (default 0.005)").above_zero();
  verb.option("--density", a->pair.density, "Density, kg/m^3 (default 2000)").above_zero();
  verb.option("--speed", a->pair.speed, "Impact speed, m/s (default 0.1)").above_zero();
  verb.footer(
      "Example: scree test-plugin build/plugins/contact/my_law.so normal_stiffness=5000\n"
      "Exit status: 0 if no check failed, 1 otherwise.");
  verb.action([a] { return test_plugin(*a); });
}

}  // namespace scree::tool
