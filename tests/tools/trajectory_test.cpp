#include "program.hpp"

using namespace scree::test;

#if SCREE_TEST_PICTURES
namespace {

const std::string in_two_stages =
    with(discs, "duration = 1e-4\n", "") +
    "[[stage]]\nname = 'first'\nduration = 5e-5\n[[stage]]\nname = 'second'\nduration = 5e-5\n"
    "[snapshot]\nevery = 2e-5\nh5md = true\n";

}  // namespace

TEST_CASE("a run that goes back to an earlier state ends with the same trajectory", "[tools]") {
  const Workspace w(in_two_stages);
  REQUIRE(w.run().status == 0);
  const std::string whole = w.text("out/trajectory.h5md");
  CHECK_THAT(w.text("out/written.txt"), Catch::Contains("\ntrajectory.h5md\n"));
  REQUIRE(w.scree("resume out --from first --overwrite").status == 0);
  CHECK((w.text("out/trajectory.h5md") == whole));
  // Without its file, nothing is dropped.
  std::filesystem::remove(w / "out/trajectory.h5md");
  const Outcome refused = w.scree("resume out --from first --overwrite");
  CHECK(refused.status == 2);
  CHECK_THAT(
      refused.err,
      Catch::Contains("trajectory.h5md: cannot be read (") &&
          Catch::Contains("; put it back as the run wrote it, or begin the run anew with --overwrite"));
  CHECK(w.has("out/final_state.h5"));
}
#endif

TEST_CASE("a trajectory needs the time between its frames, and is written only if it is asked for",
          "[tools]") {
  const Workspace w(std::string(discs) + "[snapshot]\nh5md = true\n");
  const Outcome refused = w.run();
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err,
             Catch::Contains("scene.toml:28:8: a trajectory needs the time between its frames; give every"));
  REQUIRE(w.run("--set snapshot.h5md=false").status == 0);
  CHECK_FALSE(w.has("out/trajectory.h5md"));
}
