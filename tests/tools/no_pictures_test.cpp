#include "program.hpp"

#if !SCREE_TEST_PICTURES

using namespace scree::test;

namespace {

const std::string snapshots = "[snapshot]\nevery = 1e-4\n";
const std::string chart = "[[chart]]\nname = 'work'\nprobe = 'energy'\ny = 'work'\n";
const std::string reason = "this scree was built without pictures (SCREE_PICTURES=OFF)";
const std::string cure = "build it with VTK (preset release)";

}  // namespace

TEST_CASE("without pictures a scene that requests them is refused, with a command to run it", "[tools]") {
  for (const std::string& tables : {snapshots, snapshots + chart}) {
    const Workspace w(discs + tables);
    for (const char* call : {"run scene.toml --out out", "check scene.toml"})
      check_refused(w, w.scree(call), "scene.toml:27:1: " + reason + ", but the scene requests them; ",
                    " (--set 'snapshot={}'), or " + cure);
  }
}

TEST_CASE("a scene that requests pictures runs if they are switched off, with its charts", "[tools]") {
  const Workspace w(discs + snapshots + chart);
  CHECK(w.run("--set snapshot={}").status == 0);
  CHECK(w.has("out/series/energy.csv"));
  CHECK_FALSE(w.has("out/snapshots"));
  CHECK(w.text("out/charts/work.png").starts_with("\x89PNG"));
}

TEST_CASE("render reports that there are no pictures, and a study has its charts", "[tools]") {
  const Workspace w;
  check_refused(w, w.scree("render ."), reason + "; ", cure);
  const Outcome study = w.scree("accuracy scene.toml --out study --count 2 --coarsest 1");
  CHECK(study.status == 0);
  CHECK(study.err.empty());
  CHECK(w.has("study/charts/worst_error.png"));
}

#endif
