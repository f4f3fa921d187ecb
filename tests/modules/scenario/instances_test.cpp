#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a boundary that refuses to start is reported where the file names it", "[scenario]") {
  const TemporaryFolder folder;
  PluginHost both({SCREE_TEST_PLUGINS, SCREE_TEST_BROKEN});
  const std::string leaning = "[[boundary]]\nplugin = 'refuses_to_start'\n";
  const auto first = folder.write("first.toml", with(discs, "[[boundary]]", leaning + "[[boundary]]"));
  CHECK(message([&] { scenario::read_plan(first, {}, both); }) ==
        first.string() + ":18:10: refuses_to_start: there is no wall to lean on; add one before it");
  const auto last = folder.write("last.toml", discs + ("\n" + leaning));
  CHECK_NOTHROW(scenario::read_plan(last, {}, both));
}
