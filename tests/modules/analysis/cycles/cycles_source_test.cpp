#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <scree/cycles/cycles_source.hpp>
#include <scree/error.hpp>

using namespace scree::cycles;
using Catch::Matchers::Contains;
using scree::test::TemporaryFolder;

namespace {

const std::string lengths = "time [s],length_x [m],length_y [m]\n0,2,4\n1,2.1,4\n2,2,4.4\n3,2,4.8\n";

CyclesRequest of_run(const TemporaryFolder& folder) {
  CyclesRequest request;
  request.directory = folder.path().string();
  return request;
}

}  // namespace

TEST_CASE("of a run the first series with the columns is taken", "[cycles_source]") {
  const TemporaryFolder folder;
  CyclesRequest request = of_run(folder);
  CHECK_THROWS_WITH(series_file(request), Contains("there is no series/*.csv; give the directory of a run"));
  std::filesystem::create_directory(folder / "series");
  folder.write("series/a.csv", "time [s],energy [J]\n0,1\n");
  CHECK_THROWS_WITH(series_file(request), Contains("no series has length_x and length_y"));
  folder.write("series/c.csv", lengths), folder.write("series/b.csv", lengths);
  CHECK(series_file(request) == folder / "series/b.csv");
  request.strain = "energy [J]";
  CHECK(series_file(request) == folder / "series/a.csv");
  request.strain = "volume";
  CHECK_THROWS_WITH(series_file(request), Contains("no series has the columns 'volume'; name one"));
  request.probe = "walls";
  CHECK(series_file(request) == folder / "series/walls.csv");
}

TEST_CASE("without a period each row is a cycle, and lengths refer to the first that counts",
          "[cycles_source]") {
  const TemporaryFolder folder;
  CyclesRequest request;
  request.drop = 2;
  const CyclesSource source = read_cycles(folder.write("a.csv", lengths), request, std::nullopt);
  CHECK(source.period == 0);
  CHECK(source.minimum_times == std::vector<double>{0, 1, 2, 3});
  // L_y/4.4 − L_x/2 − 0
  const double expected[] = {4 / 4.4 - 1, 4 / 4.4 - 1.05, 0, 4.8 / 4.4 - 1};
  for (std::size_t n = 0; n < 4; ++n) CHECK(source.series.strain[n] == Approx(expected[n]).margin(1e-15));
  request.load = "length_x";
  CHECK_THROWS_WITH(read_cycles(folder / "a.csv", request, std::nullopt),
                    Contains("a.csv: --load and --start without a period; give --period"));
}

TEST_CASE("with a period a series is read at the minima of the load, up to its end", "[cycles_source]") {
  const TemporaryFolder folder;
  std::string text = "time [s],strain\n";
  for (int k = 0; k <= 20; ++k) text += std::to_string(k * 0.5) + "," + std::to_string(k) + "\n";
  folder.write("a.csv", text);
  CyclesRequest request;
  request.strain = "strain";
  const LoadTimes load{{2, 1}, 7.2};  // minima at 1, 3, 5 and 7 s
  const CyclesSource source = read_cycles(folder / "a.csv", request, load);
  CHECK(source.minimum_times == std::vector<double>{1, 3, 5, 7});
  CHECK(source.series.strain == std::vector<double>{2, 6, 10, 14});
  CHECK(source.stage_period == 2);
  request.period = 3;
  request.first_minimum = 0;
  CHECK(read_cycles(folder / "a.csv", request, load).series.strain == std::vector<double>{0, 6, 12});
}
