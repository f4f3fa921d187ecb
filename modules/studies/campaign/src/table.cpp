#include "table_columns.hpp"

#include <fmt/format.h>

#include <scree/campaign/report.hpp>
#include <scree/files/csv_line.hpp>

namespace scree::campaign {

using files::csv_line;
using files::csv_number;

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
    row.push_back(point.seed ? std::to_string(*point.seed) : csv_number(number_of(outcome, "seed")));
    row.push_back(status_name(outcome.status));
    row.push_back(finished ? std::to_string(outcome.expectations.size()) : "");
    row.push_back(finished ? std::to_string(outcome.expectations.size() - outcome.unmet()) : "");
    row.push_back(fmt::format("{}", fmt::join(outcome.warnings, " | ")));
    for (const std::string& name : names)
      if (listed(name)) row.push_back(csv_number(number_of(outcome, name)));
    text += csv_line(row);
  }
  return text;
}

}  // namespace scree::campaign
