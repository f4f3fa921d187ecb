#include "program.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

using scree::test::check_refused;
using scree::test::Workspace;

namespace {

// 2000 samples of 0.001 s: strain of 5e-6 at 50 Hz with phase 0.5, and a tenth of it at 100 Hz, on a drift.
std::string series(double step = 0.001) {
  std::string text = "time [s],strain [1],kinetic [J],stage\n# by hand\n";
  for (int k = 0; k < 2000; ++k) {
    const double t = step * k, turn = 2 * std::numbers::pi * 50 * t;
    const double x = 1e-3 * t + 5e-6 * std::sin(turn + 0.5) + 5e-7 * std::sin(2 * turn);
    text += fmt::format("{},{},0,load\n", t, x);
  }
  return text;
}

std::vector<std::vector<double>> numbers_of(const std::string& out) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; words >> word;) rows.back().push_back(std::atof(word.c_str()));
  }
  return rows;
}

}  // namespace

TEST_CASE("spectrum prints amplitude, phase and errors of a frequency and its harmonics", "[tools]") {
  const Workspace w;
  w.write("box.csv", series());
  for (const char* column : {"strain", "'strain [1]'"}) {
    const auto outcome =
        w.scree(fmt::format("spectrum --csv box.csv --frequency 50 --out out --column {}", column));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.starts_with("strain [1]: 2000 samples, 0 s to 1.999 s, step 0.001 s, drift: linear\n"));
    CHECK(outcome.out.find(" 1/Hz\n") != std::string::npos);
    const auto rows = numbers_of(outcome.out);
    REQUIRE(rows.size() > 5);
    CHECK(rows[2][0] == 50);
    CHECK(rows[2][2] == Approx(5e-6).epsilon(1e-9));
    CHECK(rows[2][4] == Approx(0.5).epsilon(1e-9));
    CHECK(rows[3][0] == 100);
    CHECK(rows[3][2] == Approx(5e-7).epsilon(1e-9));
    CHECK(std::abs(rows[4][2]) < 1e-14);
  }
  const std::string table = w.text("out/spectrum.csv");
  CHECK(table.starts_with("frequency [Hz],amplitude [1]\n0,"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 1002);
  CHECK(w.has("out/spectrum.png"));
}

TEST_CASE("spectrum detrends by the mean over one period too", "[tools]") {
  const Workspace w;
  w.write("box.csv", series());
  const auto outcome =
      w.scree("spectrum --csv box.csv --frequency 50 --column strain --detrend period-average");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(numbers_of(outcome.out)[2][2] == Approx(5e-6).epsilon(1e-9));
  CHECK(w.has("spectrum.csv"));
}

TEST_CASE("spectrum without a frequency lists the strongest lines", "[tools]") {
  const Workspace w;
  w.write("box.csv", series());
  const auto outcome = w.scree("spectrum --csv box.csv --column strain");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.status == 0);
  const auto rows = numbers_of(outcome.out);
  CHECK(rows[2][0] == Approx(50).epsilon(1e-5));
  CHECK(rows[3][0] == Approx(100).epsilon(1e-4));
  const auto none = w.scree("spectrum --csv box.csv --column kinetic");
  CHECK(none.status == 0);
  CHECK(none.out.find("no line of three or more periods stands out of the noise\n") != std::string::npos);
}

TEST_CASE("spectrum writes the lines that it finds, and their decay", "[tools]") {
  const Workspace w;
  std::string text = "time [s],x [kg/m^3]\n";
  for (int k = 0; k < 1000; ++k)
    text += fmt::format("{},{}\n", 0.001 * k,
                        0.5 * std::exp(-5.0 * 0.001 * k) * std::sin(2 * std::numbers::pi * 0.08 * k));
  w.write("x.csv", text);
  const auto outcome = w.scree("spectrum --csv x.csv --column 'x [kg/m^3]'");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find("lines.csv\n") != std::string::npos);
  // Q = pi f / rate.
  CHECK(numbers_of(outcome.out)[2][6] == Approx(std::numbers::pi * 80 / 5).epsilon(1e-6));
  const std::string lines = w.text("lines.csv");
  CHECK(lines.starts_with(
      "# series: x.csv\nfrequency [Hz],frequency_error [Hz],amplitude [kg/m^3],amplitude_error [kg/m^3],"
      "phase [rad],phase_error [rad],quality,quality_error\n"));
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 3);
  REQUIRE(w.scree("spectrum --csv x.csv --column x --frequency 80").status == 0);
  CHECK(w.text("lines.csv").find("\n80,,0.") != std::string::npos);  // given, not found
}

TEST_CASE("spectrum replaces its own files of the series, others only with --overwrite", "[tools]") {
  const Workspace w;
  w.write("box.csv", series()), w.write("other.csv", series());
  const std::string strain = " --column strain --frequency 50 --out out";
  for (int k = 0; k < 2; ++k) REQUIRE(w.scree("spectrum --csv box.csv" + strain).status == 0);
  const auto refused = [&](const std::string& begin) {
    const auto outcome = w.scree("spectrum --csv other.csv" + strain);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.starts_with("scree: out/" + begin));
    CHECK(outcome.err.ends_with("give another directory with --out, or --overwrite\n"));
  };
  const std::string before = w.text("out/lines.csv");
  refused("spectrum.csv: is there already, of ");
  CHECK(w.text("out/lines.csv") == before);
  CHECK(w.scree("spectrum --csv other.csv --overwrite" + strain).status == 0);
  CHECK(w.text("out/lines.csv").starts_with("# series: ../other.csv\n"));
  for (const std::string name : {"spectrum.csv", "lines.csv", "spectrum.png"}) {
    std::filesystem::remove_all(w / "out");
    std::filesystem::create_directory(w / "out");
    w.write("out/" + name, "precious\n");
    refused(name + ": is there already, and not of a series, and this is of other.csv");
    CHECK(w.text("out/" + name) == "precious\n");
  }
}

TEST_CASE("spectrum warns of a last line without a line break", "[tools]") {
  const Workspace w;
  std::string text = series();
  text.resize(text.size() - 8);  // within the last number but one
  w.write("box.csv", text + "1,0,load");
  const auto outcome = w.scree("spectrum --csv box.csv --column strain --frequency 50");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.find("box.csv: line 2002, the last, has no line break") != std::string::npos);
}

TEST_CASE("spectrum warns of unequal steps", "[tools]") {
  const Workspace w;
  std::string text = "time,x\n";
  for (int k = 0; k < 100; ++k) text += fmt::format("{},{}\n", k + 0.3 * (k % 2), k % 7);
  w.write("x.csv", text);
  const auto outcome = w.scree("spectrum --csv x.csv --column x");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.starts_with(
      "scree: warning: x.csv: the steps differ, so spectrum.csv is of straight lines"));
}

TEST_CASE("spectrum refuses what it cannot analyse in one line", "[tools]") {
  const Workspace w;
  w.write("box.csv", series());
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("spectrum --out out " + arguments), begin, end);
  };
  const std::string strain = "--column strain --csv box.csv ";
  refused("--csv box.csv --column strin", "box.csv:1:1: there is no column 'strin'",
          "did you mean 'strain [1]'?");
  refused("--csv box.csv --column stage", "box.csv:3:", "write a number such as 1.5e-3");
  refused(strain + "--frequency 500", "box.csv: --frequency 500 is not below half the sampling rate, 500 Hz",
          "sample more often");
  refused(strain + "--frequency 0.5", "box.csv: --frequency 0.5 has less than a period",
          "or a longer record");
  refused("--csv none.csv --column x", "none.csv: there is no such file", "check the path");
  const auto table = [&](const std::string& text, const std::string& begin, const std::string& end) {
    w.write("t.csv", text);
    refused("--csv t.csv --column x", "t.csv:" + begin, end);
  };
  table("time,x\n0,1\n", "2:1: the file ends after 1 sample", "give 8 or more");
  table("", "1:1: there is no header", "such as 'time [s],strain'");
  table("time,x\n", "1:1: the file ends after 0 samples", "give 8 or more");
  table("time,x\n0,1\n1,2\n1,3\n", "4:1: time 1 follows 1", "give times that increase, in the first column");
  table("time,x\n0,1\n,2\n", "3:1: time '' is not a number", "write a number such as 1.5e-3");
  table("time [ms],x\n0,1\n", "1:1: the first column has the unit 'ms'", "give times in s there");
  table("time,x\n0,1\n1,1e200\n", "3:1: 1e+200 is beyond 1e+150", "check it, or give another unit");
  w.write("spectrum.csv", series());
  const auto own = w.scree("spectrum --csv spectrum.csv --column strain");
  CHECK(own.status == 2);
  CHECK(own.err ==
        "scree: spectrum.csv: the spectrum would replace this file; give another directory with --out\n");
}
