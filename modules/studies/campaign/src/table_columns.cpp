#include "table_columns.hpp"

#include "setting_json.hpp"

#include <limits>
#include <set>

namespace scree::campaign {

std::vector<std::string> number_names(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const Outcome& outcome : outcomes)
    for (const auto& [name, value] : outcome.numbers)
      if (known.insert(name).second) names.push_back(name);
  return names;
}

double number_of(const Outcome& outcome, const std::string& name) {
  for (const auto& [known, value] : outcome.numbers)
    if (known == name) return value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> point_header(const Campaign& campaign) {
  std::vector<std::string> header;
  if (!campaign.cases.empty()) header.push_back("case");
  append(header, campaign.varying_keys());
  return header;
}

std::vector<std::string> point_cells(const Campaign& campaign, const Point& point) {
  std::vector<std::string> cells;
  if (!campaign.cases.empty()) cells.push_back(point.case_name);
  for (const std::string& key : campaign.varying_keys()) {
    const Setting* setting = point.find(key);
    cells.push_back(setting ? setting_text(setting->value) : "");
  }
  return cells;
}

void append(std::vector<std::string>& cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

}  // namespace scree::campaign
