#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/campaign/report.hpp>
#include <scree/files/csv_line.hpp>

namespace scree::campaign {

using files::csv_line;
using files::csv_number;

namespace {

void append(std::vector<std::string>& cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

// Names of the quantities of all runs, in order of first appearance.
std::vector<std::string> number_names(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const Outcome& outcome : outcomes)
    for (const auto& [name, value] : outcome.numbers)
      if (known.insert(name).second) names.push_back(name);
  return names;
}

// Columns that identify a point, without its seed: "case" if there are cases, and the keys that vary.
std::vector<std::string> point_header(const Campaign& campaign) {
  std::vector<std::string> header;
  if (!campaign.cases.empty()) header.push_back("case");
  append(header, campaign.varying_keys());
  return header;
}

// Empty if the case of the point does not set a key.
std::vector<std::string> point_cells(const Campaign& campaign, const Point& point) {
  std::vector<std::string> cells;
  if (!campaign.cases.empty()) cells.push_back(point.case_name);
  for (const std::string& key : campaign.varying_keys()) {
    const Setting* setting = point.find(key);
    cells.push_back(setting ? setting_text(setting->value) : "");
  }
  return cells;
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct Mean {
  double mean = missing, standard_error = missing;
};

Mean mean_of(const std::vector<double>& values) {
  const double n = double(values.size());
  if (values.empty()) return {};
  double sum = 0, squares = 0;
  for (const double x : values) sum += x;
  const double mean = sum / n;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (n - 1) / n) : missing};
}

std::vector<std::string> cells_of(const Outcome* first, std::size_t count,
                                  const std::vector<std::string>& names) {
  const auto finished = [](const Outcome& o) { return o.status == Status::finished; };
  std::vector<std::string> cells = {std::to_string(std::count_if(first, first + count, finished))};
  for (const std::string& name : names) {
    std::vector<double> values;
    for (const Outcome* o = first; o != first + count; ++o)
      if (const double value = o->number(name); std::isfinite(value)) values.push_back(value);
    const Mean m = mean_of(values);
    append(cells, {csv_number(m.mean), csv_number(m.standard_error)});
  }
  return cells;
}

}  // namespace

std::string table_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes) {
  const std::vector<std::string> names = number_names(outcomes);
  std::vector<std::string> header = {"run"};
  append(header, point_header(campaign));
  append(header, {"seed", "status", "expectations", "expectations_met", "warnings"});
  // The seed of the scenario, if the campaign has no seeds.
  const auto listed = [](const std::string& name) { return name != "seed"; };
  for (const std::string& name : names)
    if (listed(name)) header.push_back(name);
  std::string text = csv_line(header);
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const Point& point = campaign.points[k];
    const Outcome& outcome = outcomes[k];
    const bool finished = outcome.status == Status::finished;
    std::vector<std::string> row = {point.name};
    append(row, point_cells(campaign, point));
    row.push_back(point.seed ? std::to_string(*point.seed) : csv_number(outcome.number("seed")));
    row.push_back(status_name(outcome.status));
    row.push_back(finished ? std::to_string(outcome.expectations.size()) : "");
    row.push_back(finished ? std::to_string(outcome.expectations.size() - outcome.unmet()) : "");
    row.push_back(fmt::format("{}", fmt::join(outcome.warnings, " | ")));
    for (const std::string& name : names)
      if (listed(name)) row.push_back(csv_number(outcome.number(name)));
    text += csv_line(row);
  }
  return text;
}

std::string means_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes) {
  std::vector<std::string> names = number_names(outcomes);
  std::erase(names, "seed");
  std::vector<std::string> header = point_header(campaign);
  header.push_back("runs");
  for (const std::string& name : names) append(header, {name + "_mean", name + "_standard_error"});
  std::string text = csv_line(header);
  // Points that differ only in the seed are consecutive, as the seed varies fastest.
  const std::size_t seeds = std::max<std::size_t>(1, campaign.seeds.size());
  for (std::size_t k = 0; k < outcomes.size(); k += seeds) {
    std::vector<std::string> row = point_cells(campaign, campaign.points[k]);
    append(row, cells_of(&outcomes[k], seeds, names));
    text += csv_line(row);
  }
  return text;
}

}  // namespace scree::campaign
