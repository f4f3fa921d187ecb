#include "campaign_table.hpp"

#include "numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/report/record.hpp>

namespace scree::report {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// A quantity has the names of a probe, a column and a statistic, or of a method, a column and a peak.
bool is_quantity(const std::string& name) {
  return std::count(name.begin(), name.end(), '.') >= 2 && !name.ends_with("_error");
}

}  // namespace

CampaignTable::CampaignTable(const Results& results)
    : results_(results), table_(results.directory / "table.csv") {
  for (const auto& column : table_.columns()) {
    if (column.name == "seed") break;
    if (column.name != "run") keys_.push_back(column.name);
  }
  find_quantities(results.record);
  std::map<std::vector<std::string>, std::size_t> numbers;  // of combinations by their values
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    std::vector<std::string> values;
    for (const std::string& key : keys_) values.push_back(table_.text(row, key));
    const auto [known, is_new] = numbers.try_emplace(values, combinations_.size());
    if (is_new) combinations_.push_back({values, {}});
    if (table_.text(row, "status") == "finished") combinations_[known->second].rows.push_back(row);
  }
}

// Those of `collect`; without any what expectations and spectra have.
void CampaignTable::find_quantities(const Json& record) {
  constexpr std::size_t most = 12;
  for (const Json& name : list_in(record, "collect"))
    if (name.is_string() && table_.has(name.get<std::string>()))
      quantities_.push_back(name.get<std::string>());
  if (!quantities_.empty()) return;
  const std::set<std::string> keys(keys_.begin(), keys_.end());
  for (const auto& column : table_.columns())
    if (is_quantity(column.name) && !keys.contains(column.name) && quantities_.size() < most)
      quantities_.push_back(column.name);
}

Mean CampaignTable::mean(const Combination& combination, const std::string& quantity) const {
  std::vector<double> values;
  for (const std::size_t row : combination.rows)
    if (const double value = table_.number(row, quantity); std::isfinite(value)) values.push_back(value);
  if (values.empty()) return {missing, missing};
  const double n = double(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, values.size() > 1 ? std::sqrt(squares / (n - 1) / n) : missing};
}

bool CampaignTable::is_numeric(std::size_t key) const {
  std::set<double> values;
  for (const Combination& combination : combinations_) {
    const double value = parsed(combination.values[key]);
    if (!std::isfinite(value)) return false;
    values.insert(value);
  }
  return values.size() > 1;
}

std::string CampaignTable::short_name(std::size_t key) const {
  const auto last = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
  const auto same = [&](const std::string& other) { return last(other) == last(keys_[key]); };
  return std::count_if(keys_.begin(), keys_.end(), same) > 1 ? keys_[key] : last(keys_[key]);
}

std::string CampaignTable::unit(const std::string& quantity) const {
  const std::size_t first = quantity.find('.'), last = quantity.rfind('.');
  if (first == last) return "";
  const std::string probe = quantity.substr(0, first), column = quantity.substr(first + 1, last - first - 1);
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    if (table_.text(row, "status") != "finished") continue;
    try {
      const files::CsvRows rows(results_.directory / table_.text(row, "run") / "series" / (probe + ".csv"));
      for (const auto& one : rows.columns())
        if (one.name == column) return one.unit;
    } catch (const Error&) {
      // The run has no such series.
    }
    return "";
  }
  return "";
}

}  // namespace scree::report
