#include "exported_frames.hpp"
#include "program_verbs.hpp"
#include "state_fields.hpp"

#include <charconv>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

struct FieldsArguments {
  std::vector<std::string> sources;
  std::string out, plane, lower, upper;
  std::optional<double> width, spacing;
  bool average = false, overwrite = false;
  unsigned threads = 1;
  PluginOptions plugins;
};

// Numbers with commas between them.
std::vector<double> numbers_of(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  for (bool more = true; more; ++at) {
    double number = 0;
    const auto [next, failed] = std::from_chars(at, end, number);
    if (failed != std::errc() || !std::isfinite(number) || (next != end && *next != ','))
      throw Error(option, "'" + text + "' is not a list of numbers with commas", "give for example 0,0,0.01");
    numbers.push_back(number);
    more = next != end;
    at = next;
  }
  return numbers;
}

std::optional<Vec3> corner_of(const std::string& option, const std::string& text, int dimension) {
  if (text.empty()) return std::nullopt;
  const std::vector<double> numbers = numbers_of(option, text);
  if (numbers.size() != std::size_t(dimension))
    throw Error(option, fmt::format("has {} numbers, but the scene has {} axes", numbers.size(), dimension),
                "give one for each axis");
  Vec3 corner = {};
  for (std::size_t k = 0; k < numbers.size(); ++k) corner[int(k)] = numbers[k];
  return corner;
}

fields::GridRequest request_of(const FieldsArguments& arguments, int dimension) {
  fields::GridRequest request;
  request.width = arguments.width.value_or(0);
  request.spacing = arguments.spacing.value_or(0);
  request.lower = corner_of("--lower", arguments.lower, dimension);
  request.upper = corner_of("--upper", arguments.upper, dimension);
  if (arguments.plane.empty()) return request;
  const std::string axes = dimension == 2 ? "xy" : "xyz";
  const auto axis = axes.find(arguments.plane[0]);
  if (axis == std::string::npos || arguments.plane.size() < 3 || arguments.plane[1] != '=')
    throw Error("--plane", "'" + arguments.plane + "' is not an axis of the scene and a place on it",
                "give for example --plane " + axes.substr(axes.size() - 1) + "=0.01");
  request.plane_axis = int(axis);
  request.plane = numbers_of("--plane", arguments.plane.substr(2)).front();
  return request;
}

fs::path file_of(const FieldsArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  fs::path source = fs::absolute(arguments.sources.front()).lexically_normal();
  if (!source.has_filename()) source = source.parent_path();
  return (fs::is_directory(source) ? source.filename() : source.stem()).string() + "-fields.csv";
}

ExitStatus compute_fields(const FieldsArguments& arguments) {
  FieldsOptions options;
  options.out = file_of(arguments);
  options.average = arguments.average;
  options.overwrite = arguments.overwrite;
  options.threads = arguments.threads;
  options.request = [&](int dimension) { return request_of(arguments, dimension); };
  for (const std::string& source : arguments.sources) options.states.push_back(state_of(source));
  PluginHost host = make_host(arguments.plugins);
  write_fields(options, host);
  return ExitStatus::success;
}

}  // namespace

void add_fields_verb(CommandLine& line) {
  Verb verb =
      line.verb("fields", "Density, momentum and stress of states as smooth fields on a grid, with balances");
  auto a = std::make_shared<FieldsArguments>();
  verb.option("sources", a->sources, "States (.h5) of one run, or its directory for the last one")
      .required()
      .existing_path();
  verb.option("--width", a->width, "(m) radius of the kernel; default: two mean diameters").above_zero();
  verb.option("--spacing", a->spacing, "(m) from point to point; default: half the width").above_zero();
  verb.option("--lower", a->lower, "(m) corner of the grid; default: the bodies, or the period")
      .shown_as("X,Y,Z");
  verb.option("--upper", a->upper, "(m) opposite corner").shown_as("X,Y,Z");
  verb.option("--plane", a->plane, "A grid of one layer, such as z=0.01 (m)").shown_as("AXIS=M");
  verb.option("--out", a->out, "File .csv or .vti (ParaView); default: the name of the source, here, .csv")
      .shown_as("FILE");
  verb.flag("--average", a->average, "One mean of all states instead of each");
  verb.option("--threads", a->threads, "The fields have the same bits for any number").between(1, 1024);
  verb.flag("--overwrite", a->overwrite, "Replace the file");
  add_plugin_options(verb, a->plugins);
  verb.footer(
      "Several states: a .csv has them one after another; .vti files are numbered and a .pvd lists them.\n"
      "Printed: what the balances of forces in each state, of mass from state to state, and of mass and momentum\n"
      "over a step from the last state leave open, over the largest term of a body or contact.\n"
      "Columns and equations: modules/analysis/fields/README.md\n"
      "Example: scree fields runs/first/states/*.h5 --average --plane y=0.02 --out first.vti");
  verb.action([a] { return compute_fields(*a); });
}

}  // namespace scree::tool
