#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/run/charts.hpp>

using namespace scree;
using namespace scree::run;

TEST_CASE("a profile has a curve for each of its times, over the middles of the bins", "[run]") {
  const std::map<std::string, std::vector<double>> columns = {
      {"time", {0, 1, 2, 3}}, {"fill_1", {0.1, 0.2, 0.3, 0.4}}, {"fill_2", {1, 2, 3, 4}}};
  const ColumnOf column = [&](const std::string& probe, const std::string& name) {
    CHECK(probe == "density");
    return columns.at(name);
  };
  scenario::ChartPlan plan;
  plan.profile = scenario::ProfilePlan{"density", {"fill_1", "fill_2"}, 0, 8, 2};
  const charts::ChartSpec two = chart_of(plan, column);
  REQUIRE(two.series.size() == 2);
  CHECK(two.series[0].name == "t = 1 s");
  CHECK(two.series[0].x == std::vector<double>{2, 6});
  CHECK(two.series[0].y == std::vector<double>{0.2, 2});
  CHECK(two.series[1].name == "t = 3 s");
  CHECK(two.series[1].y == std::vector<double>{0.4, 4});
  plan.profile->curves = 9;  // as many as there are samples
  CHECK(chart_of(plan, column).series.size() == 4);
  CHECK_THROWS_WITH(
      chart_of(plan, [](const std::string&, const std::string&) { return std::vector<double>(); }),
      Catch::Contains("its probe has no samples"));
}
