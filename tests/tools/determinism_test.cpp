#include "program.hpp"

#include <set>

#include <catch2/catch.hpp>

using scree::test::Workspace;

TEST_CASE("the 16 discs end with the same bits for any number of threads and every instruction level",
          "[tools]") {
  const Workspace w;
  std::set<std::string> hashes;
  for (const std::string threads : {"1", "2", "4"})
    for (const std::string level : {"baseline", ""}) {
      // Without a given level: the best one of this processor.
      const std::string environment = level.empty() ? "" : "SCREE_LEVEL=" + level + " ";
      const auto outcome = w.shell(
          environment +
          "scree run '" SCREE_TEST_SOURCE
          "/scenarios/verification/discs-16.toml' --set chart=[] --overwrite --quiet --out out --threads " +
          threads);
      INFO(outcome.err);
      REQUIRE(outcome.status == 0);
      hashes.insert(w.record()["state_hash"].get<std::string>());
    }
  CHECK(hashes.size() == 1);
}
