#include "scene_charts.hpp"

#include "report_support.hpp"

#include <cmath>

#include <scree/report/record.hpp>
#include <scree/report/result_tables.hpp>

using namespace scree;
using namespace scree::report;
using namespace scree::test;

namespace {

Results results_of(const TemporaryFolder& folder) {
  return {folder.path(), parse_record(text_of(folder / "run.json")), "run", "run"};
}

std::string energies(int rows, const std::string& friction = "2") {
  std::string text = "time [s],kinetic_translation [J],dissipated_friction [J],created [J],residual [J]\n";
  for (int k = 0; k < rows; ++k) text += std::to_string(k) + ",1," + friction + ",0,1e-9\n";
  return text;
}

}  // namespace

TEST_CASE("columns are read up to the line that is being written", "[report]") {
  const TemporaryFolder folder;
  write(folder, "series/a.csv", "time [s],v [m/s]\n0,1\n1,nan\n2,word\n3,4");
  Columns columns(tables_in(folder.path()));
  CHECK(columns.of("a", "time") == std::vector<double>{0, 1, 2});
  REQUIRE(columns.of("a", "v").size() == 3);
  CHECK(columns.of("a", "v")[0] == 1);
  CHECK(std::isnan(columns.of("a", "v")[1]));
  CHECK(std::isnan(columns.of("a", "v")[2]));
  CHECK(columns.of("a", "none").empty());
  CHECK(columns.of("none", "v").empty());
}

TEST_CASE("the charts of the scene are drawn", "[report]") {
  const TemporaryFolder folder;
  write_run(folder);
  Columns columns(tables_in(folder.path()));
  Figures figures;
  CHECK(add_scene_charts(results_of(folder), columns, figures));
  CHECK_THAT(figures.html(), Catch::Contains("<svg") && Catch::Contains("<figcaption>k over t</figcaption>"));
}

TEST_CASE("charts whose table is missing leave a line", "[report]") {
  const TemporaryFolder folder;
  write_run(folder);
  std::filesystem::remove_all(folder / "series");
  Columns columns(tables_in(folder.path()));
  Figures figures;
  CHECK(add_scene_charts(results_of(folder), columns, figures));
  CHECK_THAT(figures.html(), Catch::Contains("The charts of the scene are not drawn: "));
}

TEST_CASE("without charts the energies that can be seen are drawn", "[report]") {
  const TemporaryFolder folder;
  write(folder, "series/e.csv", energies(20));
  Columns columns(tables_in(folder.path()));
  Figures figures;
  add_energy_chart(columns, figures);
  CHECK_THAT(figures.html(), Catch::Contains("dissipated friction; kinetic translation</desc>") &&
                                 !Catch::Contains("created"));
}

TEST_CASE("a few samples, and probes of other things, are no chart of energies", "[report]") {
  const TemporaryFolder folder;
  write(folder, "series/a.csv", energies(7));
  write(folder, "series/b.csv", "time [s],v [m/s]\n0,1\n");
  write(folder, "series/c.csv", "");
  Columns columns(tables_in(folder.path()));
  Figures figures;
  add_energy_chart(columns, figures);
  CHECK(figures.empty());
}
