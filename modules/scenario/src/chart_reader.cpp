#include "output_keys.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/scenario/charts.hpp>
#include <scree/scenario/names.hpp>

namespace scree::scenario {

namespace {

// The probe of a chart: as named, or as the first of its curves, "<probe>.<column>", says.
const ProbeColumns& probe_of(const document::Table& t, const std::string& curve,
                             const std::vector<ProbeColumns>& probes) {
  std::vector<std::string> names;
  for (const ProbeColumns& probe : probes) names.push_back(probe.probe);
  const std::size_t dot = curve.find('.');
  if (t.optional(chart_keys.probe) || dot == curve.npos)
    return probes[find_name(t, "probe", "probe", read(t, chart_keys.probe), names)];
  return probes[find_name(t, "y", "probe", curve.substr(0, dot), names, 0)];
}

// The column that a key, or an element of its array, names: "<column>" or "<probe>.<column>".
std::size_t find_column(const document::Table& t, const char* key, const std::string& text,
                        const ProbeColumns& columns, const std::vector<ProbeColumns>& probes,
                        std::size_t element = document::Table::whole) {
  const std::vector<std::string>& names = columns.names;
  const bool whole = std::find(names.begin(), names.end(), text) != names.end();
  const std::size_t dot = whole ? text.npos : text.find('.');
  const std::string probe = dot == text.npos ? columns.probe : text.substr(0, dot);
  const auto is_probe = [&](const ProbeColumns& other) { return other.probe == probe; };
  if (probe != columns.probe && std::any_of(probes.begin(), probes.end(), is_probe))
    throw t.error(
        key, element,
        fmt::format("'{}' is a column of another probe than '{}'", files::one_line(text), columns.probe),
        "define a quantity of each in [derived], and draw these");
  const std::string column = probe == columns.probe && dot != text.npos ? text.substr(dot + 1) : text;
  return find_name(t, key, "column", column, names,
                   element == document::Table::whole ? std::nullopt : std::optional(element));
}

std::string as_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// What a unit measures; empty if that is not one quantity.
std::string quantity_of(const std::string& unit) {
  static constexpr const char* quantities[][2] = {
      {"J", "energy"}, {"N", "force"},      {"m", "length"}, {"m/s", "velocity"},           {"Pa", "stress"},
      {"s", "time"},   {"Hz", "frequency"}, {"W", "power"},  {"rad/s", "angular velocity"}, {"rad", "angle"}};
  for (const auto& [of, quantity] : quantities)
    if (unit == of) return quantity;
  return "";
}

// Whether a label that the user gave contains the unit: in brackets, or as its last word.
bool says_unit(const std::string& label, const std::string& unit) {
  return label.find_first_of("([") != std::string::npos || label == unit || label.ends_with(' ' + unit);
}

// Sets the label and the unit of an axis; the unit is empty if the label contains it.
void set_axis(const document::Table& t, const StringKey& key, const std::string& words,
              const std::string& column_unit, std::string& label, std::string& unit) {
  label = t.string(key, words);
  unit = t.optional(key) && says_unit(label, column_unit) ? "" : column_unit;
}

// Adds curves of the given columns. Returns their common unit; empty if units differ, which the names then
// contain.
std::string add_curves(const ProbeColumns& columns, const std::vector<std::size_t>& at, const std::string& x,
                       ChartPlan& chart) {
  const auto unit = [&](std::size_t k) { return columns.units[at[k]]; };
  bool same = true;
  for (std::size_t k = 1; k < at.size(); ++k) same &= unit(k) == unit(0);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::string words = as_words(columns.names[at[k]]);
    const std::string name = same || unit(k).empty() ? words : fmt::format("{} ({})", words, unit(k));
    chart.curves.push_back({name, columns.probe, x, columns.names[at[k]]});
  }
  return same ? unit(0) : "";
}

// The columns "<name>_1", "<name>_2", ... of a probe, and their unit.
ProfilePlan read_profile(const document::Table& t, const ProbeColumns& columns, std::string& unit) {
  ProfilePlan profile;
  profile.probe = columns.probe;
  const std::string name = read(t, chart_keys.profile);
  for (int k = 1;; ++k) {
    const std::string numbered = fmt::format("{}_{}", name, k);
    const auto found = std::find(columns.names.begin(), columns.names.end(), numbered);
    if (found == columns.names.end()) break;
    unit = columns.units[std::size_t(found - columns.names.begin())];
    profile.columns.push_back(numbered);
  }
  if (profile.columns.size() < 2)
    throw t.error(chart_keys.profile,
                  fmt::format("the probe {} has no columns {}_1, {}_2, ...", columns.probe, name, name),
                  "give the name of numbered columns, as of bins");
  profile.low = 0.5;
  profile.high = double(profile.columns.size()) + 0.5;
  if (t.optional(chart_keys.profile_range)) {
    const std::vector<double> range = t.numbers(chart_keys.profile_range, 2);
    if (range[0] >= range[1])
      throw t.error(chart_keys.profile_range, fmt::format("{:g} is not below {:g}", range[0], range[1]),
                    "give the lower value first");
    profile.low = range[0];
    profile.high = range[1];
  }
  profile.curves = int(read(t, chart_keys.profile_curves));
  return profile;
}

void read_profile_chart(const document::Table& t, const std::vector<ProbeColumns>& probes, ChartPlan& chart) {
  for (const char* key : {"x", "y"})
    if (t.has(key)) throw t.error(key, fmt::format("both profile and {} are given", key), "keep one of them");
  std::string unit;
  chart.profile = read_profile(t, probe_of(t, "", probes), unit);
  set_axis(t, chart_keys.x_label, "bin", read(t, chart_keys.profile_unit), chart.x_label, chart.x_unit);
  set_axis(t, chart_keys.y_label, as_words(read(t, chart_keys.profile)), unit, chart.y_label, chart.y_unit);
}

void read_curves(const document::Table& t, const std::vector<ProbeColumns>& probes, ChartPlan& chart) {
  for (const Key& key :
       {chart_keys.profile_range, Key(chart_keys.profile_unit), Key(chart_keys.profile_curves)})
    if (t.has(key))
      throw t.error(key, fmt::format("{} needs profile, which is not given", key.name),
                    "add profile, or remove it");
  const bool several = t.is_array(chart_keys.y);
  const std::vector<std::string> ys = several ? t.strings(chart_keys.y) : std::vector{t.string(chart_keys.y)};
  if (ys.empty()) throw t.error("y", "'y' has no columns", "give one or more columns of the probe");
  const ProbeColumns& columns = probe_of(t, ys[0], probes);
  const std::size_t x_at = find_column(t, "x", read(t, chart_keys.x), columns, probes);
  const std::string x = columns.names[x_at];
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < ys.size(); ++k) at.push_back(find_column(t, "y", ys[k], columns, probes, k));
  const std::string y_unit = add_curves(columns, at, x, chart);
  set_axis(t, chart_keys.x_label, as_words(x), columns.units[x_at], chart.x_label, chart.x_unit);
  // The names of several curves are in the legend.
  const std::string y_words = ys.size() == 1 ? as_words(columns.names[at[0]]) : quantity_of(y_unit);
  set_axis(t, chart_keys.y_label, y_words, y_unit, chart.y_label, chart.y_unit);
}

ChartPlan read_chart(const document::Table& t, const std::vector<ProbeColumns>& probes) {
  ChartPlan chart;
  chart.name = read(t, chart_keys.name);
  check_file_name(t, chart.name);
  chart.format = read(t, chart_keys.format);
  chart.title = t.string(chart_keys.title, chart.name);
  t.has(chart_keys.profile) ? read_profile_chart(t, probes, chart) : read_curves(t, probes, chart);
  chart.log_x = read(t, chart_keys.log_x);
  chart.log_y = read(t, chart_keys.log_y);
  return chart;
}

}  // namespace

std::vector<ChartPlan> read_charts(const document::Table& root, const std::vector<ProbeColumns>& probes) {
  std::vector<ChartPlan> charts;
  UniqueNames names("chart");
  for (const document::Table& t : root.tables("chart")) {
    charts.push_back(read_chart(t, probes));
    names.add(t, charts.back().name);
  }
  return charts;
}

}  // namespace scree::scenario
