#include "common_sections.hpp"

#include "html.hpp"
#include "report_support.hpp"

#include <scree/report/record.hpp>

using namespace scree::report;

namespace {

Results results_of(const std::string& record, const char* noun = "run", const char* verb = "run") {
  return {"folder/of-a-run", parse_record(record), noun, verb};
}

}  // namespace

TEST_CASE("results have the title of their record, their scene or their directory", "[report]") {
  CHECK(title_of(results_of(R"({"title": "a", "scenario": "[scene]\ntitle = \"b\"\n"})")) == "a");
  CHECK(title_of(results_of(R"({"scenario": "[scene]\ntitle = \"b\"\n"})")) == "b");
  CHECK(title_of(results_of(R"({"scenario": "[time]\nstep = 1\n"})")) == "of-a-run");
  CHECK(title_of(results_of(R"({"scenario": "="})")) == "of-a-run");
}

TEST_CASE("a verdict counts the expectations", "[report]") {
  const auto verdict_of = [](const std::string& expect) {
    return verdict(results_of(R"({"status": "finished", "expect": [)" + expect + "]}"));
  };
  CHECK_THAT(verdict_of(""), !Catch::Contains("xpectation"));
  CHECK_THAT(verdict_of(R"({"met": true})"), Catch::Contains("Its expectation is met."));
  CHECK_THAT(verdict_of(R"({"met": true}, {"met": true})"), Catch::Contains("All 2 expectations are met."));
  CHECK_THAT(verdict_of(R"({"met": false})"), Catch::Contains("1 of 1 expectation is not met."));
  CHECK_THAT(verdict_of(R"({"met": false}, {"met": true}, {})"),
             Catch::Contains("2 of 3 expectations are not met."));
}

TEST_CASE("warnings beyond fifty are counted", "[report]") {
  std::string all;
  for (int k = 0; k < 53; ++k) all += (k ? ", " : "") + ("\"w" + std::to_string(k) + "\"");
  const std::string html = warnings(results_of(R"({"warnings": [)" + all + "]}"));
  CHECK_THAT(html, Catch::Contains("<li>w49</li>") && !Catch::Contains("<li>w50</li>") &&
                       Catch::Contains("and 3 more"));
  CHECK(warnings(results_of("{}")).empty());
}

TEST_CASE("results are repeated by the verb that made them", "[report]") {
  CHECK_THAT(repetition(results_of("{}")), Catch::Contains("scree run scenario.toml --out again</code>"));
  CHECK_THAT(repetition(results_of(R"({"tolerance": 0.001})", "accuracy study", "accuracy")),
             Catch::Contains("scree accuracy scenario.toml --out again --tolerance 0.001"));
  CHECK_THAT(repetition(results_of(R"({"methods": [{"method": "pulse"}]})", "spectrum", "spectrum")),
             Catch::Contains("--by pulse"));
  CHECK_THAT(repetition(results_of(
                 R"({"methods": [{"method": "linear"}, {"method": "pulse"}, {"method": "sweep"}]})",
                 "spectrum", "spectrum")),
             Catch::Contains("--by all"));
  // Flags, words that the shell would take apart, lists.
  const std::string html = repetition(results_of(
      R"({"options": {"loads": true, "elastic": false, "density_to": 1e3, "quantity": ["a.b", "it's; $x"]}})",
      "study of modes", "modes"));
  CHECK_THAT(html, Catch::Contains("--out again --loads --density-to 1000.0 --quantity a.b --quantity ") &&
                       !Catch::Contains("elastic") && !Catch::Contains("other options"));
  CHECK_THAT(html, Catch::Contains(escaped("'it'\\''s; $x'")));
}
