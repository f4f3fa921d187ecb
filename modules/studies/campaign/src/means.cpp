#include "table_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/campaign/report.hpp>
#include <scree/files/csv_line.hpp>

namespace scree::campaign {

using files::csv_line;
using files::csv_number;

namespace {

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
      if (const double value = number_of(*o, name); std::isfinite(value)) values.push_back(value);
    const Mean m = mean_of(values);
    append(cells, {csv_number(m.mean), csv_number(m.standard_error)});
  }
  return cells;
}

}  // namespace

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
