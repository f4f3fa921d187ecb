#include "report_support.hpp"

#include <scree/report/result_tables.hpp>

using namespace scree;
using namespace scree::report;

TEST_CASE("tables are the series, then what lies beside the record", "[report]") {
  const test::TemporaryFolder folder;
  CHECK(tables_in(folder.path()).empty());
  test::write(folder, "series/energy.csv", "time [s],work [J]\n0,1\n");
  folder.write("energy.csv", "other\n1\n");
  folder.write("peaks.csv", "method,frequency [Hz]\n");
  folder.write("run.json", "{}");
  const auto tables = tables_in(folder.path());
  REQUIRE(tables.size() == 2);
  CHECK(tables.at("energy") == folder / "series/energy.csv");
  const auto columns = columns_of(tables);
  CHECK(columns[0].names == std::vector<std::string>{"time", "work"});
  CHECK(columns[0].units == std::vector<std::string>{"s", "J"});
  CHECK(columns[1].probe == "peaks");
}
