#include "probe_columns.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include <scree/error.hpp>
#include <scree/probes.hpp>

namespace scree::tool {

namespace {

// A value that the parameter accepts; lists are long enough for pairs of bodies.
std::vector<double> example_of(const scree_parameter& p) {
  if (p.type == SCREE_LIST) return {1, 2, 3, 4};
  if (p.type == SCREE_VECTOR) return {0, 0, 0};
  if (p.type == SCREE_PROGRAM) return {0, 1};
  for (const double value : {2.0, 1.0, 0.5, p.minimum, p.maximum})
    if (!Parameters::problem(p, {value})) return {value};
  return {0};
}

// The parameters with examples for what is required; with_lists: also for lists that may be absent.
Parameters completed(Parameters parameters, bool with_lists) {
  const scree_plugin& plugin = parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    const bool alternative = p.excludes && parameters.given(p.excludes);
    const bool wanted = p.flags & SCREE_REQUIRED || p.excludes || (with_lists && p.type == SCREE_LIST);
    if (!wanted || alternative || parameters.given(p.key)) continue;
    if (p.type == SCREE_INPUT)
      parameters.set_input(p.key, "probe.column", "unit of the column");
    else
      parameters.set(p.key, example_of(p));
  }
  return parameters;
}

std::optional<Probe> example(const Parameters& parameters, int dimension) {
  for (const bool with_lists : {true, false}) try {
      return Probe(completed(parameters, with_lists), dimension);
    } catch (const Error&) {
    }
  return std::nullopt;
}

// The name with <n> for the number at the end of each of its parts: position_2 is position_<n>.
std::string pattern_of(const std::string& name) {
  std::string pattern;
  for (std::size_t k = 0; k < name.size();) {
    std::size_t end = k;
    while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end]))) ++end;
    const bool ends_part = end > k && k > 0 && (end == name.size() || name[end] == '_');
    pattern += ends_part ? "<n>" : end > k ? name.substr(k, end - k) : name.substr(k, 1);
    k = std::max(end, k + 1);
  }
  return pattern;
}

// Columns of which several have a pattern stand once, where the first is.
std::vector<ColumnLine> lines_of(const Probe& probe) {
  const std::vector<std::string> names = probe.names(), units = probe.units(), meanings = probe.meanings();
  std::map<std::string, std::size_t> alike;
  for (const std::string& name : names) ++alike[pattern_of(name)];
  std::vector<ColumnLine> lines;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const std::string pattern = pattern_of(names[c]);
    const std::string name = alike[pattern] > 1 ? pattern : names[c];
    const bool is_new =
        std::none_of(lines.begin(), lines.end(), [&](const ColumnLine& l) { return l.name == name; });
    if (is_new) lines.push_back({name, units[c].empty() ? "1" : units[c], meanings[c]});
  }
  return lines;
}

void only_in(const char* dimensions, ColumnLine& line) {
  line.meaning = std::string(dimensions) + " only" + (line.meaning.empty() ? "" : "; " + line.meaning);
}

bool has(const std::vector<ColumnLine>& lines, const ColumnLine& line) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const ColumnLine& l) { return l.name == line.name && l.unit == line.unit; });
}

}  // namespace

std::vector<ColumnLine> described_columns(const Parameters& parameters) {
  const std::optional<Probe> flat = example(parameters, 2), spatial = example(parameters, 3);
  std::vector<ColumnLine> in_2d, in_3d;
  if (flat) in_2d = lines_of(*flat);
  if (spatial) in_3d = lines_of(*spatial);
  std::vector<ColumnLine> lines = in_3d;
  for (ColumnLine& line : lines)
    if (!has(in_2d, line)) only_in("3D", line);
  for (ColumnLine& line : in_2d)
    if (!has(in_3d, line)) only_in("2D", line), lines.push_back(line);
  return lines;
}

}  // namespace scree::tool
