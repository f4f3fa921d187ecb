#include "text_table.hpp"

#include "report_support.hpp"

#include <cmath>

using namespace scree::report;

TEST_CASE("a table keeps words and numbers up to a line that is cut off", "[report]") {
  const scree::test::TemporaryFolder folder;
  folder.write("t.csv", "run,size [m],n\n\"a,b\",0.5,\nc,x,2\nd,1");
  const TextTable table(folder / "t.csv");
  REQUIRE(table.rows() == 2);
  CHECK(table.columns()[1].unit == "m");
  CHECK(table.has("size"));
  CHECK_FALSE(table.has("seed"));
  CHECK(table.text(0, "run") == "a,b");
  CHECK(table.number(0, "size") == 0.5);
  CHECK(std::isnan(table.number(0, "n")));
  CHECK(std::isnan(table.number(1, "size")));
  CHECK(table.number(1, "n") == 2);
  CHECK(table.text(0, "none").empty());
}

TEST_CASE("a table that is missing or no table is empty", "[report]") {
  const scree::test::TemporaryFolder folder;
  CHECK(TextTable(folder / "none.csv").rows() == 0);
  folder.write("t.csv", "");
  CHECK(TextTable(folder / "t.csv").columns().empty());
}
