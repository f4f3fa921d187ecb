#include "temporary_folder.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>

using scree::files::CsvRows;
using scree::test::TemporaryFolder;

namespace {

std::string refusal(const std::string& text, const std::string& column = "strain") {
  const TemporaryFolder folder;
  const auto file = folder.write("t.csv", text);
  try {
    CsvRows rows(file);
    const std::size_t number = rows.column(column);
    while (rows.next()) rows.number(number);
  } catch (const scree::Error& error) {
    return std::string(error.what()).substr(file.string().size());
  }
  return "";
}

}  // namespace

TEST_CASE("rows are read one by one, past comments and blank lines", "[csv_rows]") {
  const TemporaryFolder folder;
  CsvRows rows(folder.write("t.csv",
                            "\xef\xbb\xbf# from a run\n\ntime [s], \"strain [1]\",stage\r\n0,1e-3,load\r\n"
                            "# later\n+0.5, -2 ,hold\n1,3,hold"));
  REQUIRE(rows.columns().size() == 3);
  CHECK(rows.columns()[1].name == "strain");
  CHECK(rows.columns()[1].unit == "1");
  CHECK(rows.column("strain") == 1);
  CHECK(rows.column("strain [1]") == 1);
  std::vector<double> values;
  while (rows.next()) values.push_back(rows.number(0)), values.push_back(rows.number(1));
  CHECK(values == std::vector<double>{0, 1e-3, 0.5, -2, 1, 3});
}

TEST_CASE("cells in quotes have commas and doubled quotes", "[csv_rows]") {
  const TemporaryFolder folder;
  CsvRows rows(folder.write(
      "t.csv", "run,strain\n\"case=a,seed=1\",2\n \"say \"\"a, b\"\"\" , 3\n\"\",4\n\"open,5\n"));
  std::vector<std::string> runs;
  std::vector<double> strains;
  while (rows.next()) runs.push_back(rows.text(0)), strains.push_back(rows.number(1));
  CHECK(runs == std::vector<std::string>{"case=a,seed=1", "say \"a, b\"", "", "\"open"});
  CHECK(strains == std::vector<double>{2, 3, 4, 5});
}

TEST_CASE("a table that cannot be read is refused with line, column and cure", "[csv_rows]") {
  CHECK(refusal("time [s],strian\n0,1\n") == ":1:1: there is no column 'strain'; did you mean 'strian'?");
  CHECK(refusal("time,a [m],b\n0,1,2\n") == ":1:1: there is no column 'strain'; there are: time, a [m], b");
  CHECK(refusal("time,strain [m]\n0,1\n", "strain [1]") ==
        ":1:1: there is no column 'strain [1]'; did you mean 'strain [m]'?");
  CHECK(refusal("time,strain [m],strain [1]\n0,1,2\n") ==
        ":1:1: there is more than one column 'strain'; rename all but one, or give its unit too");
  CHECK(refusal("# a\ntime,strain\n0,1\n1,x\n") ==
        ":4:3: strain 'x' is not a number; write a number such as 1.5e-3");
  CHECK(refusal("time,str\x01in\n0,x\n", "str\x01in").starts_with(":2:3: str\\x01in 'x' is not a number; "));
  CHECK(refusal("time,strain\n0,nan\n").starts_with(":2:3: strain 'nan' is not finite; "));
  CHECK(refusal("time,strain\n0,\n").starts_with(":2:3: strain '' is not a number; "));
  CHECK(refusal("time,strain\n0,1,2\n").starts_with(":2:1: 3 cells under 2 columns; "));
  CHECK(refusal("time;strain\n0;1\n").starts_with(":1:1: the columns are separated by semicolons; "));
  CHECK(refusal("").find("there is no header; ") != std::string::npos);
  CHECK(
      refusal("# t, s\n0,1\n1,2\n") ==
      ":2:1: there is no header, but numbers; name the columns in the first line, such as 'time [s],strain'");
  CHECK(refusal("0,strain\n1,2\n").empty());
  CHECK(refusal(std::string("time,strain\n0,\0\n", 15)).starts_with(":2:3: not a text file"));
  CHECK(refusal("\x1f\x8b\x08").starts_with(": the file is compressed; unpack it with gunzip"));
  CHECK(refusal("time,strain\n" + std::string(2000000, '1')).starts_with(":2:1: the line is longer than "));
}

TEST_CASE("numbers of a run may be infinite or NaN, and a row that was cut off is told", "[csv_rows]") {
  const TemporaryFolder folder;
  CsvRows rows(folder.write("t.csv", "time,a\n0,nan\n1,-inf\n2,0.5"));
  CHECK(rows.is_whole());
  REQUIRE(rows.next());
  CHECK(std::isnan(rows.any_number(1)));
  CHECK_THROWS_AS(rows.number(1), scree::Error);
  REQUIRE(rows.next());
  CHECK(rows.any_number(1) == -INFINITY);
  CHECK(rows.is_whole());
  REQUIRE(rows.next());
  CHECK_FALSE(rows.is_whole());
  CHECK(rows.any_number(1) == 0.5);
  CHECK_FALSE(rows.next());
  CHECK_FALSE(CsvRows(folder.write("h.csv", "time,a")).is_whole());
}

TEST_CASE("a table that is no file is refused", "[csv_rows]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(CsvRows(folder / "none.csv"),
                    (folder / "none.csv").string() + ": there is no such file; check the path");
  CHECK_THROWS_WITH(CsvRows(folder.path()),
                    folder.path().string() + ": is not a regular file; give a text file");
}
