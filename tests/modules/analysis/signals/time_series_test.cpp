#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/time_series.hpp>

using scree::signals::read_time_series;
using scree::test::TemporaryFolder;

namespace {

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.write("t.csv", text);
  try {
    read_time_series(file, "x", 2);
  } catch (const scree::Error& error) {
    return std::string(error.what()).substr(file.string().size());
  }
  return "";
}

}  // namespace

TEST_CASE("a column is read over the time, and nothing else", "[time_series]") {
  const TemporaryFolder folder;
  const auto file = folder.write("t.csv", "time [s],stage,x [m/s]\n0,load,1\n0.5,load,-2\n2,,3e-4\n");
  const auto series = read_time_series(file, "x", 2);
  CHECK(series.name == "x");
  CHECK(series.unit == "m/s");
  CHECK(series.times == std::vector<double>{0, 0.5, 2});
  CHECK(series.values == std::vector<double>{1, -2, 3e-4});
  CHECK(series.duration() == 2);
  CHECK(series.mean_step() == 1);
}

TEST_CASE("several columns are read in one pass, in the order in which they are named", "[time_series]") {
  const TemporaryFolder folder;
  const auto file = folder.write("t.csv", "time [s],x,y [Pa]\n0,1,4\n0.5,-2,5\n");
  const auto series = read_time_series(file, std::vector<std::string>{"y [Pa]", "x"}, 2);
  REQUIRE(series.size() == 2);
  CHECK(series[0].unit == "Pa");
  CHECK(series[0].values == std::vector<double>{4, 5});
  CHECK(series[1].name == "x");
  CHECK(series[1].times == std::vector<double>{0, 0.5});
  CHECK(series[1].values == std::vector<double>{1, -2});
}

TEST_CASE("times and values of which nothing can be said are refused with their line", "[time_series]") {
  CHECK(refusal("time,x\n1,1\n0.5,1\n") ==
        ":3:1: time 0.5 follows 1; give times that increase, in the first column");
  CHECK(refusal("time,x\n0,1\n0,1\n").starts_with(":3:1: time 0 follows 0; "));
  CHECK(refusal("time [ms],x\n0,1\n1,1\n") ==
        ":1:1: the first column has the unit 'ms'; give times in s there");
  for (const char* name : {"time (ms)", "time_ms", "t/ms"})
    CHECK_THAT(refusal(std::string(name) + ",x\n0,1\n1,1\n"),
               Catch::Contains("has the unit ms in its name; give times in s there, or another name"));
  CHECK(refusal("time_of_ms_run,x\n0,1\n1,1\n") == "");
  CHECK(refusal("time,x\n0,1\n") == ":2:1: the file ends after 1 sample; give 2 or more");
  CHECK(refusal("time,x\n0,-1e151\n1,0\n").starts_with(":2:1: -1e+151 is beyond 1e+150; "));
  CHECK(refusal("time,x\n0,1e-151\n1,-1e-160\n") ==
        ":3:1: no value is above 1e-151; give another unit, in which one is above 1e-150");
  CHECK(refusal("time,x\n0,0\n1,0\n") == "");
  CHECK(refusal("time,x\n0,1e-160\n1,1\n") == "");
  CHECK(refusal("time\tx\n0\t1\n1\t0\n").starts_with(":1:1: the columns are separated by tabs; "));
  CHECK(refusal("time,x\n0,1\n1e-200,1\n") ==
        ":3:1: the times span 1e-200 s; check the unit of the times, s");
}
