#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/scenario/charts.hpp>

namespace charts = scree::charts;
using namespace scree::scenario;

TEST_CASE("a planned chart has its columns in units with prefixes", "[scenario]") {
  ChartPlan plan;
  plan.title = "Stress";
  plan.x_label = "time", plan.x_unit = "s", plan.y_label = "stress", plan.y_unit = "Pa";
  plan.curves = {{"a", "box", "time", "stress"}, {"b", "empty", "time", "stress"}};
  const auto column = [](const std::string& probe, const std::string& name) -> std::vector<double> {
    if (probe == "empty") return {};
    return name == "time" ? std::vector<double>{0, 0.002} : std::vector<double>{1000, 5000};
  };
  const auto chart = chart_of(plan, column);
  CHECK(chart.x_label == "time (ms)");
  CHECK(chart.y_label == "stress (kPa)");
  REQUIRE(chart.series.size() == 1);
  CHECK(chart.series[0].x == std::vector<double>{0, 2});
  CHECK(chart.series[0].y == std::vector<double>{1, 5});
  plan.curves.erase(plan.curves.begin());
  CHECK_THROWS_WITH(chart_of(plan, column), Catch::Contains("its probe has no samples"));
}

TEST_CASE("a profile has a curve for each of its times, over the middles of the bins", "[scenario]") {
  const std::map<std::string, std::vector<double>> columns = {
      {"time", {0, 1, 2, 3}}, {"fill_1", {0.1, 0.2, 0.3, 0.4}}, {"fill_2", {1, 2, 3, 4}}};
  const ColumnOf column = [&](const std::string& probe, const std::string& name) {
    CHECK(probe == "density");
    return columns.at(name);
  };
  ChartPlan plan;
  plan.profile = ProfilePlan{"density", {"fill_1", "fill_2"}, 0, 8, 2};
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
