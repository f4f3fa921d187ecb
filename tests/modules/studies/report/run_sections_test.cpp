#include "report_support.hpp"

using namespace scree::test;

TEST_CASE("the page of a run has its verdict, stages, balances, charts and how to repeat it", "[report]") {
  const TemporaryFolder folder;
  write_run(folder);
  const std::string page = checked_page(folder);
  for (const char* part : {"<title>Beads &amp; &lt;walls&gt;</title>",
                           "The run finished.",
                           "1 of 2 expectations is not met.",
                           "<h2>Scene</h2>",
                           "20\u202F000, 60\u202F000 degrees of freedom",
                           "<h2>Stages</h2>",
                           "by its condition",
                           "<h2>Expectations</h2>",
                           "2 ± 0.1",
                           "at most 10⁻⁸",
                           "not met",
                           "<h2>Warnings</h2>",
                           "use &lt;b&gt;a shorter one",
                           "<h2>Charts</h2>",
                           "<svg",
                           "<h2>Balances</h2>",
                           "1.5·10⁻⁷",
                           "2\u00A0%",
                           "<h2>Speed</h2>",
                           "2.5 million particle-steps per second",
                           "2 min 30 s",
                           "<h2>How to repeat it</h2>",
                           "scree run scenario.toml --out again",
                           "scree 1.2.3, commit <code>0123abcd4567</code>",
                           "0123456789abcdef",
                           "contact/linear <code>00bb</code>",
                           "title = &quot;Beads&quot;"})
    CHECK_THAT(page, Catch::Contains(part));
}

TEST_CASE("the page says how a run ended", "[report]") {
  const TemporaryFolder folder;
  const auto page = [&](const std::string& record) {
    folder.write("run.json", record);
    return checked_page(folder);
  };
  CHECK_THAT(page(R"({"status": "failed", "error": "particle <3>: is too fast; use a shorter step"})"),
             Catch::Contains("The run failed: particle &lt;3&gt;: is too fast; use a shorter step"));
  CHECK_THAT(page(R"({"status": "interrupted"})"),
             Catch::Contains("The run was interrupted before its end."));
  CHECK_THAT(page(R"({"status": "running"})"),
             Catch::Contains("The run had not ended when this page was written."));
  // A title of the directory where there is no other.
  CHECK_THAT(page("{}"), Catch::Contains("<h1>" + folder.path().filename().string() + "</h1>"));
}
