#include "cycles_workspace.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

using scree::test::check_refused;
using scree::test::Workspace;
using scree::test::write_run;

TEST_CASE("cycles replaces results of the same series only", "[tools]") {
  const Workspace w;
  write_run(w, "a");
  write_run(w, "b");
  REQUIRE(w.scree("cycles a --out kept").status == 0);
  CHECK(w.scree("cycles a --out kept").status == 0);
  const std::string before = w.text("kept/cycles.csv");
  check_refused(w, w.scree("cycles b --out kept --drop 30"),
                "kept/cycles.csv: is there already, of " + (w / "a/series/box.csv").string() +
                    ", and this is of b/series/box.csv; ",
                "or --overwrite");
  // However it is spelt, and where it has been moved to.
  CHECK(w.scree("cycles ./a --out kept").status == 0);
  CHECK(w.scree("cycles " + (w / "a").string() + " --out kept").status == 0);
  CHECK(w.scree("cycles a").status == 0);
  std::filesystem::rename(w / "a", w / "moved");
  CHECK(w.scree("cycles moved").status == 0);
  std::filesystem::rename(w / "moved", w / "a");
  CHECK(w.text("kept/cycles.csv") == before);
  CHECK(w.scree("cycles b --out kept --drop 30 --overwrite").status == 0);
  CHECK(w.record("kept", "cycles.json")["series"] == "../b/series/box.csv");
  std::filesystem::create_directories(w / "other");
  w.write("other/cycles.csv", "mine\n");
  check_refused(w, w.scree("cycles a --out other"), "other/cycles.csv: is there already, ", "or --overwrite");
  CHECK(w.text("other/cycles.csv") == "mine\n");
}

TEST_CASE("cycles does not lose verdicts of other runs", "[tools]") {
  const Workspace w;
  for (const char* run : {"a,1", "b", "c"}) write_run(w, run);
  REQUIRE(w.scree("cycles a,1 b --out kept").status == 0);
  CHECK(w.scree("cycles c b/ " + (w / "a,1").string() + " --out kept").status == 0);
  const std::string before = w.text("kept/verdicts.csv");
  check_refused(w, w.scree("cycles b c --out kept"), "kept/verdicts.csv: has other runs, such as ../a,1; ",
                "or --overwrite");
  CHECK(w.text("kept/verdicts.csv") == before);
  CHECK(w.scree("cycles b c --out kept --overwrite").status == 0);
  std::filesystem::create_directories(w / "other");
  w.write("other/verdicts.csv", "mine\n");
  check_refused(w, w.scree("cycles b c --out other"),
                "other/verdicts.csv: is there already, and no table of verdicts; ", "or --overwrite");
  check_refused(w, w.scree("cycles b c b/"), "b/ is given twice", "give each run once");
}

TEST_CASE("a report written after cycles has their class", "[tools]") {
  const Workspace w;
  write_run(w, "a");
  REQUIRE(w.scree("cycles a").status == 0);
  REQUIRE(w.scree("report a").status == 0);
  CHECK_THAT(w.text("a/report.html"), Catch::Contains("scree cycles: ratcheting."));
}
