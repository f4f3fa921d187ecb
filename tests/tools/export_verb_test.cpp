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
  const Outcome nowhere = w.scree("export out --format csv --out missing/bodies.csv");
  CHECK(nowhere.status == 2);
  CHECK_THAT(nowhere.err, Catch::Contains("there is no folder "));
  CHECK_THAT(w.scree("export out --format csv --overwrite --out empty").err,
             Catch::Contains("empty: is not a regular file; give another --out"));
  CHECK_THAT(w.scree("export out --format csv --overwrite --out out/final_state.h5").err,
             Catch::Contains("holds what is exported, or another state"));
  CHECK_THAT(w.scree("export empty --format xyz").err,
             Catch::Contains("empty: has neither a state nor snapshots of its bodies; give the directory"));
}

namespace {

// Two discs pressed together by 1e-4 m, and the lower one into a wall by as much.
const std::string pressed_discs =
    "[scene]\ndimension = 2\n[time]\nstep = 1e-5\nduration = 2e-5\n[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 0\n"
    "[[particle]]\nid = 5\nposition = [0, 0.0099]\nradius = 0.01\nmass = 1e6\n"
    "[[particle]]\nid = 2\nposition = [0, 0.0298]\nradius = 0.01\nmass = 1e6\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0]\nnormal = [0, 1]\n";

}  // namespace

TEST_CASE("export writes the contacts of a run as a table", "[tools]") {
  const Workspace w(pressed_discs);
  REQUIRE(w.run().status == 0);
  const Outcome outcome = w.scree("export out --format contacts-csv");
  INFO(outcome.err);
  CHECK(outcome.out == "out-contacts.csv: 2 contacts\n");
  const std::vector<std::string> lines = lines_of(w.text("out-contacts.csv"));
  REQUIRE(lines.size() == 6);
  CHECK(lines[2] == "# forces: evaluated from positions, velocities and springs, since the state has none");
  CHECK(lines[3] == "a,b,wall,normal_x,normal_y,force_x [N],force_y [N],overlap [m],sliding,x [m],y [m]");
  // k δ = 1 N; in two steps the heavy discs move by less than 1e-15 m.
  CHECK_THAT(lines[4],
             Catch::StartsWith("2,5,,0,1,0,1.00000000000") || Catch::StartsWith("2,5,,0,1,0,0.99999999999"));
  CHECK_THAT(lines[5], Catch::StartsWith("5,,floor,0,1,0,1.00000000000") ||
                           Catch::StartsWith("5,,floor,0,1,0,0.99999999999"));
  CHECK_THAT(w.scree("export out --format contacts-csv").err,
             Catch::Contains("out-contacts.csv: is there already"));
  CHECK(w.scree("export out/final_state.h5 --format contacts-csv --out state.csv").status == 0);
  CHECK(w.text("state.csv") == w.text("out-contacts.csv"));
}

#if SCREE_TEST_PICTURES
TEST_CASE("a snapshot has the same table of contacts as the state at its time", "[tools]") {
  const Workspace w(pressed_discs + "[snapshot]\nevery = 1e-5\n");
  REQUIRE(w.run().status == 0);
  REQUIRE(w.scree("export out --format contacts-csv --out state.csv").status == 0);
  CHECK(w.text("state.csv").find("# forces") == std::string::npos);
  const Outcome outcome =
      w.scree("export out/snapshots/particles_0000000002.vtp --format contacts-csv --out frame.csv");
  INFO(outcome.err);
  CHECK(w.text("frame.csv") == w.text("state.csv"));
}

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

TEST_CASE("export replaces no result of a run", "[tools]") {
  const Workspace w;
  REQUIRE(w.run().status == 0);
  for (const char* file : {"run.json", "series/energy.csv", "written.txt", "series/../run.json"}) {
    const std::string before = w.text(std::string("out/") + file);
    const Outcome refused = w.scree(std::string("export out --format csv --overwrite --out out/") + file);
    CHECK(refused.status == 2);
    CHECK(refused.err == std::string("scree: out/") + file +
                             ": is a result of scree, which exports do not replace; give another --out\n");
    CHECK(w.text(std::string("out/") + file) == before);
  }
  CHECK(w.scree("export out --format csv --out out/mine.csv").status == 0);
  CHECK(w.scree("export out --format csv --out out/mine.csv --overwrite").status == 0);
}

#if SCREE_TEST_PICTURES
TEST_CASE("export of a run that blew up takes its last snapshot, or says what there is", "[tools]") {
  const std::string fast = with(discs, "random_velocity = 0.1", "random_velocity = 50");
  const Workspace w(with(fast, "step = 1e-5", "step = 1e-5\nstep_guard = false") +
                    "[snapshot]\nevery = 1e-5\n");
  REQUIRE(w.run("--set time.duration=0.1").status == 3);
  REQUIRE_FALSE(w.has("out/final_state.h5"));
  const Outcome last = w.scree("export out --format csv");
  INFO(last.err);
  CHECK(last.status == 0);
  CHECK(w.scree("export out --format xyz").status == 0);
  // The last frame of all.
  const std::string frames = w.text("out.xyz"), time = "# time [s]: ";
  const std::string table = w.text("out.csv");
  const std::size_t at = table.find(time) + time.size();
  const std::size_t newest = frames.rfind("Time=");
  REQUIRE(newest != std::string::npos);
  CHECK(std::stod(table.substr(at)) == std::stod(frames.substr(newest + 5)));
  CHECK_THAT(w.scree("export out --format contacts-csv").err,
             Catch::StartsWith("scree: out: has no state; "));
  std::filesystem::remove_all(w / "out/snapshots");
  CHECK(
      w.scree("export out --format csv --overwrite").err ==
      "scree: out: has neither a state nor snapshots of its bodies; take its final_packing.csv, or give the scene "
      "[snapshot] every or [checkpoint]\n");
}
#endif
