#include "document_support.hpp"

#include <catch2/catch.hpp>

#include <scree/document/document.hpp>
#include <scree/scenario/charts.hpp>

using namespace scree;
using namespace scree::scenario;

namespace {

const std::vector<ProbeColumns> probes = {{"energy",
                                           {"time", "work", "residual", "force", "ratio", "share", "area"},
                                           {"s", "J", "J", "N", "", "", "m^2"}}};

ChartPlan chart_with(const std::string& keys) {
  const document::Document text =
      document::Document::parse("[[chart]]\nname = 'c'\nprobe = 'energy'\n" + keys, "scene.toml");
  return read_charts(text.root(), probes).at(0);
}

void has_y(const std::string& keys, const std::string& label, const std::string& unit) {
  const ChartPlan chart = chart_with(keys);
  INFO(keys);
  CHECK(chart.y_label == label);
  CHECK(chart.y_unit == unit);
}

}  // namespace

TEST_CASE("the label of an axis is the column, or what the unit of several measures", "[scenario]") {
  has_y("y = 'work'", "work", "J");
  has_y("y = ['work', 'residual']", "energy", "J");
  has_y("y = ['area', 'area']", "", "m^2");
  has_y("y = ['ratio', 'share']", "", "");
  has_y("y = ['work', 'force']", "", "");
  CHECK(chart_with("y = ['work', 'force']").curves[1].name == "force (N)");
  CHECK(chart_with("y = ['work', 'ratio']").curves[1].name == "ratio");
  CHECK(chart_with("y = 'work'").x_label == "time");
  CHECK(chart_with("y = 'work'").x_unit == "s");
  CHECK(chart_with("y = 'work'").file_name() == "c.png");
  CHECK(chart_with("y = 'work'\nformat = 'pdf'").file_name() == "c.pdf");
}

TEST_CASE("a label of one's own gets the unit, unless it says it", "[scenario]") {
  has_y("y = 'work'\ny_label = 'energy'", "energy", "J");
  has_y("y = ['work', 'residual']\ny_label = 'energy'", "energy", "J");
  has_y("y = 'ratio'\ny_label = 'energy'", "energy", "");
  for (const std::string complete :
       {"energy (J)", "energy [J]", "energy / J", "energy in J", "J", "E (relative)"})
    has_y("y = 'work'\ny_label = '" + complete + "'", complete, "");
  has_y("y = 'work'\ny_label = 'JJ'", "JJ", "J");
  CHECK(chart_with("y = 'work'\nx_label = 'loading'").x_unit == "s");
}

TEST_CASE("a profile is a chart over the numbered columns of bins", "[scenario]") {
  const std::vector<ProbeColumns> bins = {
      {"density",
       {"time", "fill_1", "volume_1", "fill_2", "volume_2", "fill_3", "volume_3", "fill_5"},
       {"s", "", "m^3", "", "m^3", "", "m^3", ""}}};
  const auto chart = [&](const std::string& keys) {
    const document::Document text =
        document::Document::parse("[[chart]]\nname = 'c'\nprobe = 'density'\n" + keys, "scene.toml");
    return read_charts(text.root(), bins).at(0);
  };
  const ChartPlan by_number = chart("profile = 'fill'\n");
  REQUIRE(by_number.profile);
  CHECK(by_number.curves.empty());
  CHECK(by_number.profile->columns == std::vector<std::string>{"fill_1", "fill_2", "fill_3"});
  CHECK(by_number.profile->low == 0.5);
  CHECK(by_number.profile->high == 3.5);
  CHECK(by_number.x_label == "bin");
  const ChartPlan over_height = chart(
      "profile = 'volume'\nprofile_range = [0, 0.6]\nprofile_unit = 'm'\nprofile_curves = 4\nx_label = 'z'\n");
  CHECK(over_height.profile->high == 0.6);
  CHECK(over_height.profile->curves == 4);
  CHECK(over_height.x_label == "z");
  CHECK(over_height.x_unit == "m");
  CHECK(over_height.y_unit == "m^3");
  const auto refused = [&](const std::string& keys) { return scree::test::message([&] { chart(keys); }); };
  CHECK_THAT(refused("profile = 'fil'\n"),
             Catch::Contains("the probe density has no columns fil_1, fil_2, ...; "));
  CHECK_THAT(refused("profile = 'fill'\ny = 'fill_1'\n"), Catch::Contains("both profile and y are given"));
  CHECK_THAT(refused("profile = 'fill'\nprofile_range = [1, 1]\n"), Catch::Contains("1 is not below 1"));
  CHECK_THAT(refused("y = 'fill_1'\nprofile_curves = 2\n"), Catch::Contains("profile_curves needs profile"));
}

TEST_CASE("columns of a chart may name their probe, which is then the one of the chart", "[scenario]") {
  const std::vector<ProbeColumns> two = {probes[0], {"box", {"time", "strain", "x.y"}, {"s", "", "m"}}};
  const auto read = [&](const std::string& keys) {
    return read_charts(document::Document::parse("[[chart]]\nname = 'c'\n" + keys, "scene.toml").root(), two);
  };
  const auto refused = [&](const std::string& keys) { return test::message([&] { read(keys); }); };
  const ChartPlan chart = read("x = 'energy.force'\ny = ['energy.work', 'residual']").at(0);
  CHECK(chart.x_label == "force");
  CHECK(chart.curves.at(0).probe == "energy");
  CHECK(chart.curves.at(0).x == "force");
  CHECK(chart.curves.at(0).y == "work");
  CHECK(chart.curves.at(1).y == "residual");
  CHECK(read("y = 'box.strain'").at(0).y_label == "strain");
  CHECK(read("probe = 'box'\ny = 'box.strain'").at(0).curves.at(0).y == "strain");
  CHECK(read("probe = 'box'\ny = 'x.y'").at(0).curves.at(0).y == "x.y");
  CHECK(read("y = 'box.x.y'").at(0).curves.at(0).y == "x.y");
  CHECK(refused("y = 'work'").find("[[chart]] has no 'probe'") != std::string::npos);
  CHECK(refused("y = 'eneergy.work'") == "scene.toml:3:5: no probe 'eneergy'; did you mean 'energy'?");
  CHECK(refused("y = ['energy.wrk']") == "scene.toml:3:6: no column 'wrk'; did you mean 'work'?");
  CHECK(
      refused("x = 'box.strain'\ny = 'energy.work'") ==
      "scene.toml:3:5: 'box.strain' is a column of another probe than 'energy'; define a quantity of each in "
      "[derived], and draw these");
  CHECK(refused("y = ['energy.work', 'box.strain']")
            .starts_with("scene.toml:3:21: 'box.strain' is a column of"));
}
