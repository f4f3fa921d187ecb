#include "temporary_folder.hpp"

#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <sys/resource.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/run/series.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> names = {"a", "b"}, units = {"m", ""};

bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

// Lowers the limit on the size of files during its lifetime.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace

TEST_CASE("a series whose file is moved or removed says so at its next rows", "[run]") {
  const TemporaryFolder folder;
  Series series(folder / "series/p.csv", names, units, false);
  series.add(0, {1, 2});
  series.flush();
  fs::rename(folder / "series", folder / "elsewhere");
  series.flush();  // no rows
  series.add(1, {1, 2});
  CHECK_THROWS_WITH(series.flush(),
                    Catch::Contains("series/p.csv: was moved or removed while it was written"));
  folder.write("p.csv", "another");
  fs::create_directory(folder / "series");
  fs::rename(folder / "p.csv", folder / "series/p.csv");
  series.add(2, {1, 2});
  CHECK_THROWS_AS(series.flush(), Error);
  CHECK(text_of(folder / "series/p.csv") == "another");
}

TEST_CASE("the columns of a series are read back from its file with the same bits", "[run]") {
  const TemporaryFolder folder;
  Series series(folder / "series/p.csv", names, units, true);
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> odd = {0.1,  -0.0,         5e-324, 1.7976931348623157e308, 1 / 3.0, inf,
                                   -inf, std::nan(""), 1e22};
  std::vector<double> times;
  for (const double x : odd) {
    series.begin_stage(times.size() + 1);
    times.push_back(double(times.size()) / 3);
    series.add(times.back(), {x, -x});
  }
  series.flush();
  CHECK(series.rows() == odd.size());
  CHECK(series.last_time() == times.back());
  CHECK(same_bits(series.column("time"), times));
  CHECK(same_bits(series.column("a"), odd));
  CHECK(std::signbit(series.column("b")[0]));
  CHECK(text_of(folder / "series/p.csv").find("-nan") == std::string::npos);
  CHECK(series.bytes() == std::filesystem::file_size(folder / "series/p.csv"));
  CHECK_THROWS_WITH(series.column("c"),
                    Catch::Contains("p.csv:1:1: there is no column 'c'; leave the files of a run alone"));
}

TEST_CASE("a series without a file keeps its rows", "[run]") {
  Series series(names);
  series.add(0.5, {1, 2});
  CHECK(series.column("b") == std::vector<double>{2});
  CHECK(series.column("time") == std::vector<double>{0.5});
  CHECK(series.bytes() == 0);
}

TEST_CASE("a series goes on behind its former end, and drops what was written since", "[run]") {
  const TemporaryFolder folder;
  const auto file = folder / "p.csv";
  SeriesEnd end;
  {
    Series series(file, names, units, false);
    series.add(0, {1, 2});
    series.add(0.25, {3, 4});
    series.flush();
    end = {series.bytes(), series.rows(), series.last_time()};
    series.add(0.5, {5, 6});
    series.flush();
  }
  const std::string whole = text_of(file);
  {
    Series series(file, names, false, end);
    CHECK(text_of(file) == whole);
    series.cut();
    CHECK(text_of(file) == "time [s],a [m],b\n0,1,2\n0.25,3,4\n");
    CHECK(series.rows() == 2);
    CHECK(series.last_time() == 0.25);
    series.add(0.5, {5, 6});
    series.flush();
    CHECK(series.bytes() == whole.size());
  }
  CHECK(text_of(file) == whole);
  const auto refusal = [&](std::uint64_t bytes) {
    try {
      Series(file, names, false, {bytes, 2, 0.25});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CHECK_THAT(refusal(whole.size() + 1),
             Catch::Contains("p.csv: is shorter than when the checkpoint was written; "));
  CHECK_THAT(refusal(whole.size() - 1), Catch::Contains("p.csv: has no line that ends where "));
  CHECK(text_of(file) == whole);
  std::filesystem::rename(file, folder / "elsewhere.csv");
  CHECK_THAT(refusal(end.bytes), Catch::Contains("p.csv: cannot be opened (No such file or directory); "));
  std::filesystem::create_symlink(folder / "elsewhere.csv", file);
  CHECK_THAT(refusal(end.bytes),
             Catch::Contains("p.csv: cannot be opened (Too many levels of symbolic links); "));
  CHECK(text_of(folder / "elsewhere.csv") == whole);
}

TEST_CASE("a new series replaces a link instead of following it", "[run]") {
  const TemporaryFolder folder;
  folder.write("outside", "mine");
  std::filesystem::create_symlink(folder / "outside", folder / "p.csv");
  Series series(folder / "p.csv", names, units, false);
  CHECK(text_of(folder / "outside") == "mine");
  CHECK(text_of(folder / "p.csv") == "time [s],a [m],b\n");
}

TEST_CASE("a series that no longer fits on the disk ends with its last whole row", "[run]") {
  const TemporaryFolder folder;
  constexpr std::size_t limit = 20000;
  Series series(folder / "p.csv", names, units, false);
  double time = 0;
  {
    const FileSizeLimit full(limit);
    CHECK_THROWS_WITH(
        [&] {
          for (;; time += 1) series.add(time, {1 / 3.0, 2 / 3.0});
        }(),
        Catch::Contains("p.csv: cannot be written"));
  }
  const std::string text = text_of(folder / "p.csv");
  CHECK(text.ends_with('\n'));
  CHECK(text.size() == series.bytes());
  const std::size_t row = std::string("1000,0.3333333333333333,0.6666666666666666\n").size();
  CHECK(limit - text.size() < row);
  CHECK(double(series.column("a").size()) == series.column("time").back() + 1);
}
