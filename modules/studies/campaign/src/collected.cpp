#include "collected.hpp"

#include <algorithm>

#include <scree/error.hpp>
#include <scree/run/series.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names,
                                                      std::vector<std::string>& damaged) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const std::string& name : names) {
    const scenario::SeriesQuantity of = scenario::series_quantity(name);
    try {
      const std::vector<double> values = run::series_column(directory / "series" / (of.probe + ".csv"),
                                                            of.column, "run the campaign with --overwrite");
      if (!values.empty()) numbers.emplace_back(name, scenario::series_statistic(values, of.statistic));
    } catch (const Error& error) {
      if (std::find(damaged.begin(), damaged.end(), error.what()) == damaged.end())
        damaged.push_back(error.what());
    }
  }
  return numbers;
}

}  // namespace scree::campaign
