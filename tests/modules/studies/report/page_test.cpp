#include "error_line.hpp"
#include "report_support.hpp"

using namespace scree;
using namespace scree::test;

TEST_CASE("a record of other types makes a page all the same", "[report]") {
  const TemporaryFolder folder;
  folder.write("run.json", R"({"title": 3, "status": [], "stages": {"a": 1}, "expect": [1, {"met": 2}, null],
    "warnings": [{}, "w"], "inputs": [], "footprint": 7, "scenario": "= no toml", "steps": "many"})");
  CHECK_THAT(checked_page(folder), Catch::Contains("<li>w</li>"));
  for (const char* record :
       {"campaign.json", "spectrum.json", "accuracy.json", "modes.json", "quasi_static.json"}) {
    const TemporaryFolder other;
    other.write(record,
                R"({"runs": 1, "methods": {"a": [1]}, "orders": [[]], "quantities": [3], "elastic": "x",
      "collect": [1], "seeds": "a", "fixed": [], "observed": 1})");
    checked_page(other);
  }
}

TEST_CASE("what is no directory of results is refused", "[report]") {
  const TemporaryFolder folder;
  const auto refusal = [&] { return error_line([&] { report::page_of(folder.path()); }); };
  CHECK_THAT(
      refusal(),
      Catch::EndsWith(": contains no results of scree; give the directory of a run, a study or a campaign"));
  folder.write("run.json", "no record");
  CHECK_THAT(refusal(),
             Catch::EndsWith("run.json: is not a record that scree has written; run the scenario again"));
  CHECK_FALSE(report::is_page("<!DOCTYPE html><title>scree</title>"));
}
