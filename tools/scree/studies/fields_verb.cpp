#include "studies/state_fields.hpp"
#include "studies/studies.hpp"
#include "support/fields_arguments.hpp"
#include "support/last_state.hpp"
#include "support/snapshot_files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

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
  const auto kernel =
      std::find(std::begin(fields::kernel_names), std::end(fields::kernel_names), arguments.kernel);
  if (kernel != std::end(fields::kernel_names))
    request.shape = fields::KernelShape(kernel - std::begin(fields::kernel_names));
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

// One frame, all of a folder snapshots, or the state that is given or that of a run.
std::vector<fs::path> files_in(const fs::path& source) {
  const fs::path named = source.has_filename() ? source : source.parent_path();
  if (source.extension() == ".vtp" || named.filename() == "snapshots") return snapshot_files(source);
  return {state_of(source)};
}

ExitStatus compute_fields(const FieldsArguments& arguments) {
  FieldsOptions options;
  options.out = file_of(arguments);
  options.average = arguments.average;
  options.overwrite = arguments.overwrite;
  options.threads = arguments.threads;
  options.request = [&](int dimension) { return request_of(arguments, dimension); };
  for (const std::string& source : arguments.sources) {
    const std::vector<fs::path> files = files_in(source);
    options.sources.insert(options.sources.end(), files.begin(), files.end());
  }
  if (!arguments.state.empty()) options.state_of_frames = arguments.state;
  options.density_of_frames = arguments.density;
  PluginHost host = make_host(arguments.plugins);
  write_fields(options, host);
  return ExitStatus::success;
}

}  // namespace

void add_fields_verb(CommandLine& line) {
  auto a = std::make_shared<FieldsArguments>();
  Verb verb = add_fields_options(line, *a);
  verb.action([a] { return compute_fields(*a); });
}

}  // namespace scree::tool
