#include "temporary_folder.hpp"

#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

#include <scree/files/csv_line.hpp>
#include <scree/files/csv_rows.hpp>

using namespace scree::files;

TEST_CASE("cells with commas, quotes and line ends are quoted, others are not", "[files]") {
  CHECK(csv_line({"a", "b c", ""}) == "a,b c,\n");
  CHECK(csv_line({"", ""}) == ",\n");
  CHECK(csv_line({"a,b", "say \"x\"", "two\nlines"}) == "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

TEST_CASE("a cell with a comma is one column for the reader of a table", "[files]") {
  const scree::test::TemporaryFolder folder;
  const CsvRows rows(folder.write("t.csv", csv_line({"time [s]", "a, b", "c"}) + "1,2,3\n"));
  REQUIRE(rows.columns().size() == 3);
  CHECK(rows.columns()[1].name == "a, b");
}

TEST_CASE("a number has the shortest form with the same bits, and none that is missing", "[files]") {
  CHECK(csv_number(0.1) == "0.1");
  CHECK(csv_number(NAN).empty());
  CHECK(csv_number(-INFINITY).empty());
  for (const double x : {1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0})
    CHECK(std::strtod(csv_number(x).c_str(), nullptr) == x);
}
