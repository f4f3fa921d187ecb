#include "campaign_support.hpp"

using namespace scree::test;

namespace {

constexpr const char* ratcheting_record =
    R"({"series": "series/box.csv", "strain": "strain", "load": "stress [Pa]",
  "period": 2, "cycles": 4, "dropped": 2, "class": "ratcheting", "reason": "it moves <on>", "outliers": [3],
  "fit": {"intercept": 0, "slope": 1.25e-6, "slope_error": 2e-8, "rms": 3e-8}})";

}  // namespace

TEST_CASE("the page of a run has what scree cycles found", "[report]") {
  const TemporaryFolder folder;
  write_run(folder);
  CHECK(checked_page(folder).find("<h2>Cycles</h2>") == std::string::npos);
  folder.write("cycles.json", ratcheting_record);
  folder.write(
      "cycles.csv",
      "cycle,time [s],strain,fit,outlier\n0,1,0.7,,0\n1,3,0.8,,0\n2,5,0.001,0.001,0\n3,7,0.002,0.002,1\n"
      "4,9,0.003,0.003,0\n");
  const std::string page = checked_page(folder);
  for (const char* part :
       {"<h2>Cycles</h2>", "scree cycles: ratcheting.", "<dt>why</dt><dd>it moves &lt;on&gt;</dd>",
        "<dt>load</dt><dd><code>stress [Pa]</code></dd>", "<dt>cycles</dt><dd>4</dd>",
        "<dt>dropped at the start</dt><dd>2</dd>", "(1.250 ± 0.020)·10⁻⁶", "<dt>outliers</dt><dd>1</dd>",
        "<figcaption>strain at the minima of the load</figcaption>"})
    CHECK_THAT(page, Catch::Contains(part));
  // Without the table there is no chart.
  std::filesystem::remove(folder / "cycles.csv");
  CHECK(checked_page(folder).find("strain at the minima") == std::string::npos);
  folder.write("cycles.json", "{\"class\": ");
  CHECK(checked_page(folder).find("<h2>Cycles</h2>") == std::string::npos);
}

TEST_CASE("the page of a campaign has the verdicts of its runs", "[report]") {
  const TemporaryFolder folder;
  write_campaign(folder);
  folder.write("verdicts.csv",
               "run,class,cycles,slope,slope_error,rms,range,robust_slope,outliers,repeats_after,reason\n"
               "a,shakedown,60,1e-9,2e-8,0,0,0,3,,it falls\n");
  const std::string page = checked_page(folder);
  for (const char* part : {"<h2>Cycles</h2>", "<td>shakedown</td>", "it falls"})
    CHECK_THAT(page, Catch::Contains(part));
}
