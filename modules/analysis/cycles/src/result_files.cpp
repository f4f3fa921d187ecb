#include "scree/cycles/result_files.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/csv_line.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/files/paths.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::cycles {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

double on_line(const StraightLine& line, std::size_t n) { return line.intercept + line.slope * double(n); }

bool is_outlier(const CyclesResult& r, std::size_t n) {
  return std::binary_search(r.found.outliers.begin(), r.found.outliers.end(), n);
}

Json fit_of(const StraightLine& line) {
  return {{"intercept", line.intercept},
          {"slope", line.slope},
          {"slope_error", line.slope_error},
          {"rms", line.rms}};
}

// k is 0 at the first cycle that is not dropped.
Json law_of(const Slowing& s) {
  using Law = Slowing::Law;
  const bool has_line = s.law == Law::exponential_and_line || s.law == Law::power_and_line;
  const bool is_power = s.law == Law::power || s.law == Law::power_to_limit || s.law == Law::power_and_line;
  const char* const form = s.law == Law::logarithm ? "constant + amplitude log(1 + k/scale)"
                           : is_power              ? "constant + amplitude (1 + k/scale)^exponent"
                                                   : "constant + amplitude exp(-k/scale)";
  Json json = {{"form", std::string(form) + (has_line ? " + slope k" : "")},
               {"constant", s.constant},
               {"amplitude", s.amplitude},
               {"scale", s.scale}};
  if (is_power) json["exponent"] = s.exponent;
  if (has_line) json["slope"] = s.slope;
  return json;
}

// The law or line of the class, over the cycles that count.
charts::ChartSeries fitted_curve(const CyclesResult& r) {
  const Classification& c = r.found;
  const std::size_t last = r.source.series.strain.size() - 1;
  const double reference = r.source.series.strain[r.drop];
  charts::ChartSeries curve;
  if (c.slowing && c.kind != Class::late_ratcheting) {
    curve.name = law_text(*c.slowing);
    for (std::size_t n = r.drop; n <= last; ++n) {
      curve.x.push_back(double(n));
      curve.y.push_back(value_of(*c.slowing, double(n - r.drop)) - reference);
    }
    return curve;
  }
  const bool is_late = c.kind == Class::late_ratcheting;
  // Outliers pull the line of least squares away from all cycles.
  const StraightLine& fit = is_late ? c.after_settling : c.kind == Class::outliers ? c.robust : c.line;
  curve.name = fmt::format("{:.3e} per cycle", fit.slope);
  for (const std::size_t n : {is_late ? c.ratchets_from : r.drop, last}) {
    curve.x.push_back(double(n));
    curve.y.push_back(on_line(fit, n) - reference);
  }
  return curve;
}

const std::vector<std::string> verdict_columns = {"run",         "class",         "cycles", "slope",
                                                  "slope_error", "rms",           "range",  "robust_slope",
                                                  "outliers",    "repeats_after", "reason"};

}  // namespace

std::string cycles_table(const CyclesResult& r) {
  const CyclesSource& s = r.source;
  const bool loops = !s.series.loops.empty();
  std::vector<std::string> header = {"cycle", "time [s]", signals::with_unit(s.strain, s.strain_unit), "fit",
                                     "outlier"};
  if (loops) header.insert(header.end(), {"loop_area", "stiffness"});
  const bool touches = r.rattlers && !r.rattlers->touches.empty();
  if (touches) header.insert(header.end(), {"rattler", "touched_before [s]"});
  std::string text = files::csv_line(header);
  for (std::size_t n = 0; n < s.series.strain.size(); ++n) {
    std::vector<std::string> cells = {
        std::to_string(n), files::csv_number(s.minimum_times[n]), files::csv_number(s.series.strain[n]),
        n < r.drop ? "" : files::csv_number(on_line(r.found.line, n)), is_outlier(r, n) ? "1" : "0"};
    const bool has_loop = n < s.series.loops.size();
    if (loops)
      for (const double value :
           {has_loop ? s.series.loops[n].area : NAN, has_loop ? s.series.loops[n].stiffness : NAN})
        cells.push_back(files::csv_number(value));
    if (touches)
      cells.insert(cells.end(), {std::to_string(r.rattlers->touches[n].body),
                                 files::csv_number(r.rattlers->touches[n].before)});
    text += files::csv_line(cells);
  }
  return text;
}

std::string cycles_record(const CyclesResult& r, const fs::path& folder) {
  const Classification& c = r.found;
  Json json;
  json["series"] = files::relative_to(folder, r.source.file);
  json["strain"] = signals::with_unit(r.source.strain, r.source.strain_unit);
  if (!r.source.load.empty()) json["load"] = signals::with_unit(r.source.load, r.source.load_unit);
  if (r.source.period > 0) json["period"] = r.source.period;
  json["first_minimum"] = r.source.minimum_times.front();
  json["cycles"] = r.source.series.strain.size() - 1;
  json["dropped"] = r.drop;
  json["class"] = class_name(c.kind);
  json["reason"] = c.reason;
  json["ratchets"] = c.kind == Class::ratcheting || c.kind == Class::late_ratcheting;
  json["fit"] = fit_of(c.line);
  json["fit"]["robust_slope"] = c.robust.slope;
  if (c.kind == Class::late_ratcheting) {
    json["ratchets_from"] = c.ratchets_from;
    json["fit_from_there"] = fit_of(c.after_settling);
  }
  if (c.slowing) json["law"] = law_of(*c.slowing);
  json["range"] = c.range;
  json["round_off"] = c.round_off;
  if (c.period > 0) json["repeats_after"] = c.period;
  json["chance_of_repetition"] = c.period_probability;
  json["chance_of_settling"] = c.settling_probability;
  json["outliers"] = c.outliers;
  if (r.rattlers) {
    json["rattlers"] = Json::array();
    for (const Rattler& body : r.rattlers->bodies)
      json["rattlers"].push_back({{"id", body.id}, {"share_touching", body.share}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

charts::ChartSpec cycles_chart(const CyclesResult& r) {
  const std::vector<double>& strain = r.source.series.strain;
  // Relative to the first cycle that counts: the transient before it would hide the rest.
  const double reference = strain[r.drop];
  charts::ChartSeries values{"at the minima of the load", {}, {}}, outliers{"outliers", {}, {}};
  for (std::size_t n = r.drop; n < strain.size(); ++n) {
    charts::ChartSeries& series = is_outlier(r, n) ? outliers : values;
    series.x.push_back(double(n));
    series.y.push_back(strain[n] - reference);
  }
  values.line = outliers.line = charts::LineStyle::none;
  charts::ChartSpec chart;
  chart.title =
      fmt::format("{}: {}", files::one_line(fs::path(r.name + "/").parent_path().filename().string()),
                  class_name(r.found.kind));
  chart.x_label = "cycle";
  chart.y_label = fmt::format(
      "strain{}, less that of cycle {}",
      r.source.strain_unit.empty() ? "" : fmt::format(" ({})", files::one_line(r.source.strain_unit)),
      r.drop);
  chart.series = {values, fitted_curve(r)};
  if (!outliers.x.empty()) chart.series.push_back(outliers);
  return chart;
}

fs::path series_of_record(const fs::path& file) {
  std::error_code failed;
  if (!fs::exists(file, failed)) return {};
  const Json record = Json::parse(files::read_text(file), nullptr, false);
  const bool named = record.is_object() && record.contains("series") && record["series"].is_string();
  return named ? files::resolved(file.parent_path() / std::string(record["series"])) : fs::path();
}

std::string verdicts_table(const std::vector<CyclesResult>& results, const fs::path& folder) {
  std::string text = files::csv_line(verdict_columns);
  for (const CyclesResult& r : results) {
    const Classification& c = r.found;
    text += files::csv_line({files::relative_to(folder, r.name), std::string(class_name(c.kind)),
                             std::to_string(r.source.series.strain.size() - 1),
                             files::csv_number(c.line.slope), files::csv_number(c.line.slope_error),
                             files::csv_number(c.line.rms), files::csv_number(c.range),
                             files::csv_number(c.robust.slope), std::to_string(c.outliers.size()),
                             c.period > 0 ? std::to_string(c.period) : "", c.reason});
  }
  return text;
}

void check_verdicts(const fs::path& file, const std::vector<CyclesResult>& results) {
  files::CsvRows rows(file);
  if (!std::equal(rows.columns().begin(), rows.columns().end(), verdict_columns.begin(),
                  verdict_columns.end(),
                  [](const auto& column, const std::string& name) { return column.name == name; }))
    throw Error(fmt::format(
        "{}: is there already, and no table of verdicts; give another directory with --out, or --overwrite",
        file.string()));
  std::set<fs::path> runs;
  for (const CyclesResult& r : results) runs.insert(files::resolved(r.name));
  while (rows.next())
    if (const std::string run = rows.text(0); !runs.contains(files::resolved(file.parent_path() / run)))
      throw Error(
          fmt::format("{}: has other runs, such as {}; give another directory with --out, or --overwrite",
                      file.string(), files::one_line(run)));
}

}  // namespace scree::cycles
