#include "temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/cycles/result_files.hpp>
#include <scree/error.hpp>

using namespace scree::cycles;
using Catch::Matchers::Contains;
using scree::test::TemporaryFolder;

namespace {

// Four minima, of which the first does not count, the last stands off, and the others are on 0.1 + 0.2 n.
CyclesResult result_in(const std::filesystem::path& folder) {
  CyclesResult result;
  result.name = (folder / "run").string();
  result.source.file = folder / "run/series/walls.csv";
  result.source.strain = "strain", result.source.load = "stress", result.source.load_unit = "Pa";
  result.source.period = 10;
  result.source.minimum_times = {0, 10, 20, 30};
  result.source.series.strain = {7, 0.3, 0.5, 9};
  result.source.series.loops = {{1, 2, 3}, {4, NAN, 6}, {7, 8, 9}};
  result.found.kind = Class::outliers;
  result.found.reason = "one, of four";
  result.found.line = result.found.robust = {0.1, 0.2, 0.01, 0.02};
  result.found.outliers = {3};
  result.drop = 1;
  return result;
}

}  // namespace

TEST_CASE("the table of cycles has strain, line, outliers and loops", "[result_files]") {
  CHECK(
      cycles_table(result_in("")) ==
      "cycle,time [s],strain,fit,outlier,loop_area,stiffness\n"
      "0,0,7,,0,1,2\n1,10,0.3,0.30000000000000004,0,4,\n2,20,0.5,0.5,0,7,8\n3,30,9,0.7000000000000001,1,,\n");
}

TEST_CASE("the record of cycles names the series from its folder", "[result_files]") {
  const TemporaryFolder folder;
  const std::string text = cycles_record(result_in(folder.path()), folder / "run");
  const auto record = nlohmann::json::parse(text);
  CHECK(record["series"] == "series/walls.csv");
  CHECK(record["load"] == "stress [Pa]");
  CHECK(record["cycles"] == 3);
  CHECK(record["class"] == "outliers");
  CHECK(record["outliers"] == std::vector{3});
  CHECK(record["fit"]["slope"] == 0.2);
  std::filesystem::create_directory(folder / "run");
  CHECK(series_of_record(folder.write("run/cycles.json", text)) ==
        std::filesystem::weakly_canonical(folder / "run/series/walls.csv"));
  CHECK(series_of_record(folder / "none.json").empty());
  CHECK(series_of_record(folder.write("other.json", "{\"series\": 3}")).empty());
}

TEST_CASE("the chart of cycles begins at 0 with the first that counts, with outliers apart",
          "[result_files]") {
  const auto chart = cycles_chart(result_in("/a"));
  CHECK(chart.title == "run: outliers");
  REQUIRE(chart.series.size() == 3);
  CHECK(chart.series[0].x == std::vector<double>{1, 2});
  CHECK(chart.series[0].y == std::vector<double>{0, 0.5 - 0.3});
  CHECK(chart.series[1].x == std::vector<double>{1, 3});  // of the line
  CHECK(chart.series[1].y[1] == Approx(0.4));
  CHECK(chart.series[2].x == std::vector<double>{3});
}

TEST_CASE("a table of verdicts is replaced by one of the same runs or more", "[result_files]") {
  const TemporaryFolder folder;
  std::vector<CyclesResult> results = {result_in(folder.path())};
  const std::string text = verdicts_table(results, folder.path());
  CHECK_THAT(text, Contains("\nrun,outliers,3,0.2,0.01,0.02,0,0.2,1,,\"one, of four\"\n"));
  const auto file = folder.write(verdicts_name, text);
  CHECK_NOTHROW(check_verdicts(file, results));
  results[0].name += "2";
  CHECK_THROWS_WITH(check_verdicts(file, results), Contains("has other runs, such as run; "));
  CHECK_THROWS_WITH(check_verdicts(folder.write("b.csv", "run,class\n"), results),
                    Contains("no table of verdicts; "));
}
