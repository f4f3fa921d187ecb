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
