#include "campaign_support.hpp"

#include <catch2/catch.hpp>

#include <scree/campaign/outcome.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::make_run;
using test::outcome_of;

namespace {

double number(const Outcome& outcome, const std::string& name) {
  for (const auto& [known, value] : outcome.numbers)
    if (known == name) return value;
  FAIL("no number " << name);
  return 0;
}

}  // namespace

TEST_CASE("a run counts only for the point with the same resolved scenario", "[campaign]") {
  const CampaignFolder folder("collect = ['energy.time.max']\n[set]\ntime.duration = [1e-4, 2e-4]\n");
  const Campaign c = folder.read();
  const auto out = folder.folder() / "out";
  CHECK(outcome_of(c, 0, out).status == Status::missing);
  make_run(c, 0, out);
  const Outcome outcome = outcome_of(c, 0, out);
  CHECK(outcome.status == Status::finished);
  CHECK(number(outcome, "steps") == 10);
  CHECK(number(outcome, "footprint.bodies") == 9);
  CHECK(outcome.numbers[0].first == "energy.time.max");
  CHECK(outcome.numbers[0].second == Approx(1e-4));
  CHECK(outcome_of(c, 1, out).status == Status::changed);
  CHECK(outcome_of(c, 1, out).numbers.empty());
}

TEST_CASE("an invalid run.json counts as missing, an incomplete run as interrupted", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const auto out = folder.folder() / "out";
  make_run(c, 0, out);
  const std::string record = test::text_of(out / "run.json");
  const auto state_with = [&](const std::string& text) {
    folder.folder().write("out/run.json", text);
    return outcome_of(c, 0, out).status;
  };
  CHECK(state_with(test::with(record, "\"finished\"", "\"interrupted\"")) == Status::interrupted);
  CHECK(state_with(test::with(record, "\"finished\"", "\"running\"")) == Status::running);
  CHECK(state_with(test::with(record, "\"finished\"", "\"failed\"")) == Status::failed);
  for (const char* nonsense : {"", "[]", "{}", "null", "{\"scenario\": 3, \"status\": \"finished\"}"})
    CHECK(state_with(nonsense) != Status::finished);
  CHECK(state_with(record.substr(0, record.size() / 2)) == Status::missing);
}

TEST_CASE("a run.json that is nested deeper than memory allows is read but for that", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const auto out = folder.folder() / "out";
  make_run(c, 0, out);
  const std::string record = test::text_of(out / "run.json");
  std::string nested = "1";
  const std::size_t depth = 200000;
  std::string opening, closing;
  for (std::size_t k = 0; k < depth; ++k) opening += "{\"a\":", closing += "}";
  folder.folder().write(
      "out/run.json",
      test::with(record, "\"seed\":", "\"more\": " + opening + nested + closing + ", \"seed\":"));
  CHECK(outcome_of(c, 0, out).status == Status::finished);
}

TEST_CASE("a run.json that is no file counts as missing, and is told", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const auto out = folder.folder() / "out";
  std::filesystem::create_directories(out / "run.json");
  CHECK(outcome_of(c, 0, out).status == Status::missing);
  CHECK_THAT(outcome_of(c, 0, out).problem, Catch::Contains("run.json: is not a regular file"));
}

TEST_CASE("a series that is not as the run wrote it is told, not read", "[campaign]") {
  const CampaignFolder folder("collect = ['energy.time.max', 'energy.work.last']\n");
  const Campaign c = folder.read();
  const auto out = folder.folder() / "out";
  make_run(c, 0, out);
  const std::string series = test::text_of(out / "series/energy.csv");
  const auto told = [&](const std::string& text) {
    folder.folder().write("out/series/energy.csv", text);
    const Outcome outcome = outcome_of(c, 0, out);
    CHECK(outcome.status == Status::finished);
    CHECK(outcome.numbers[0].first != "energy.time.max");
    return outcome.warnings.empty() ? "" : outcome.warnings[0];
  };
  CHECK(outcome_of(c, 0, out).warnings.empty());
  CHECK_THAT(told(series.substr(0, series.size() / 2)), Catch::Contains("energy.csv:"));
  CHECK_THAT(told(series.substr(0, series.size() - 1)),
             Catch::Contains(": the line is cut off; run the campaign"));
  CHECK_THAT(told(test::with(series, "\n0,", "\n0,0,")), Catch::Contains("energy.csv:2:1: "));
  CHECK_THAT(told(test::with(series, "\n0,", "\nzero,")),
             Catch::Contains("energy.csv:2:1: time 'zero' is not a number; run the campaign"));
  CHECK_THAT(told("\n"), Catch::Contains("there is no header; run the campaign"));
}

TEST_CASE("a campaign collects derived quantities, and may change their formulas", "[campaign]") {
  const std::string scene = test::discs + std::string("[derived]\na = 'energy.kinetic_translation'\n");
  const CampaignFolder folder(
      "collect = ['derived.a.last']\n[set]\nderived.a = ['0 * energy.work + 3', '0 * energy.work + 4']\n",
      scene);
  const Campaign c = folder.read();
  REQUIRE(c.points.size() == 2);
  const auto out = folder.folder() / "out";
  for (std::size_t k = 0; k < 2; ++k) {
    make_run(c, k, out);
    CHECK(number(outcome_of(c, k, out), "derived.a.last") == 3 + double(k));
  }
  CHECK(CampaignFolder("collect = ['derived.b.last']\n", scene)
            .refusal()
            .find("no quantity 'derived.b.last'; did you mean 'derived.a.last'?") != std::string::npos);
}
