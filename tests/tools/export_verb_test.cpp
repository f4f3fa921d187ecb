#include "program.hpp"

#include <algorithm>

using namespace scree::test;

namespace {

const std::string discs_with_snapshots =
    with(discs, "duration = 1e-4", "duration = 1e-4\n[snapshot]\nevery = 5e-5");

}  // namespace

TEST_CASE("export writes the bodies of a state in each format, and scree reads them again", "[tools]") {
  const Workspace w;
  REQUIRE(w.run().status == 0);
  const Outcome data = w.scree("export out --format lammps-data --out bodies.data");
  INFO(data.err);
  CHECK(data.status == 0);
  CHECK(data.out.starts_with("bodies.data: 1 frame, "));
  CHECK_THAT(w.text("bodies.data"), Catch::StartsWith("scree packing, SI units, atom style sphere\n"));
  for (const char* format : {"lammps-dump", "liggghts-dump", "yade", "csv", "xyz"}) {
    CAPTURE(format);
    CHECK(w.scree(std::string("export out/final_state.h5 --overwrite --format ") + format + " --out bodies")
              .status == 0);
    CHECK_FALSE(w.text("bodies").empty());
  }
  CHECK(w.scree("export out --format csv --out bodies.csv").status == 0);
  // The scene begins from the table with the same bodies as it ended with.
  const std::string bodies = w.text("bodies.csv"), final_packing = w.text("out/final_packing.csv");
  CHECK(bodies.substr(bodies.find("\nid,")) == final_packing.substr(final_packing.find("\nid,")));

  CHECK(w.scree("export out --format csv --out bodies.csv").err ==
        "scree: bodies.csv: is there already; give another --out, or --overwrite\n");
  CHECK_THAT(w.scree("export out --format xzy").err, Catch::Contains("xyz"));
  std::filesystem::create_directory(w / "empty");
  CHECK_THAT(w.scree("export out --format csv --overwrite --out empty").err,
             Catch::Contains("empty: is not a regular file; give another --out"));
  CHECK_THAT(w.scree("export out --format csv --overwrite --out out/final_state.h5").err,
             Catch::Contains("holds what is exported, or another state"));
  CHECK_THAT(w.scree("export empty --format xyz").err,
             Catch::Contains("empty: has neither a state nor snapshots of its bodies; give the directory"));
}

#if SCREE_TEST_PICTURES
TEST_CASE("export joins all snapshots of a run in a dump and in extended XYZ", "[tools]") {
  const Workspace w(discs_with_snapshots);
  REQUIRE(w.run().status == 0);
  CHECK(w.scree("export out --format xyz").out.starts_with("out.xyz: 3 frames, "));
  const std::string xyz = w.text("out.xyz");
  CHECK(std::count(xyz.begin(), xyz.end(), '=') == 3 * 6);
  CHECK_THAT(xyz, Catch::Contains(
                      "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:omega:R:3:id:I:1 pbc=\"F F F\""));
  CHECK(w.scree("export out --format lammps-dump --out out.dump").out.starts_with("out.dump: 3 frames, "));
  // What a scene reads from it is the last frame.
  const std::string scene = w.text("scene.toml");
  CHECK_THAT(w.text("out.dump"),
             Catch::Contains("ITEM: TIMESTEP\n5\n") && Catch::Contains("ITEM: TIMESTEP\n10\n"));
}
#endif
