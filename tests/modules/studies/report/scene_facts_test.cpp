#include "scene_facts.hpp"

#include "report_support.hpp"

using namespace scree::report;

TEST_CASE("facts of a scene are those of its record and of its scenario", "[report]") {
  const Results results = {"",
                           {{"time", 0.25},
                            {"steps", 25000},
                            {"step", 1e-5},
                            {"bodies", 30},
                            {"scenario",
                             "[[material]]\nname = \"<glass>\"\n[[material]]\nname = \"steel\"\n[[contact]]\n"
                             "plugin = \"hertz\"\n[[contact]]\nplugin = \"hertz\"\n"}},
                           "run",
                           "run"};
  CHECK_THAT(scene_facts(results), Catch::Contains("<dt>materials</dt><dd>&lt;glass&gt;, steel</dd>") &&
                                       Catch::Contains("<dt>contact laws</dt><dd>hertz</dd>") &&
                                       Catch::Contains("<dt>bodies</dt><dd>30</dd>") &&
                                       Catch::Contains("25\u202F000 of 10\u00A0µs") &&
                                       !Catch::Contains("walls"));
}
