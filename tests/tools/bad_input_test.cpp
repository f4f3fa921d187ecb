#include "program.hpp"

using namespace scree::test;
namespace fs = std::filesystem;

namespace {

// Checks the refusal of the discs scene with one part of the text replaced.
void refused_scene(const std::string& part, const std::string& other, const std::string& begin,
                   const std::string& end) {
  const Workspace w(with(discs, part, other));
  check_refused(w, w.run(), begin, end);
}

// Checks the refusal of the discs scene with command-line options.
void refused_options(const std::string& options, const std::string& begin, const std::string& end) {
  const Workspace w;
  check_refused(w, w.run(options), begin, end);
}

}  // namespace

TEST_CASE("a wrong key, type or value is reported with position and cure", "[tools]") {
  refused_scene(
      "radius = 0.01", "radius = 0.01\nrandom_velocty = 1",
      "scene.toml:16:1: unknown key 'random_velocty' in [particles]; did you mean 'random_velocity'? ",
      "velocity_gradient, random_velocity, random, file, radius, lattice, region, springs");
  refused_scene("1e-5", "'1e-5'", "scene.toml:4:8: time.step is a string (\"1e-5\"); ",
                "give a number in s, such as 1e-5");
  refused_scene("radius = 0.01", "radius = -1", "scene.toml:15:10: particles.radius = -1 m is negative; ",
                "give a radius above 0");
  refused_scene("1e-5", "0", "scene.toml:4:8: time.step = 0 s is zero; ", "give a step above 0");
  refused_scene("1000", "nan", "scene.toml:8:11: material.density = nan is not finite; ",
                "give a number in kg/m^3");
  refused_scene("gap = 0.1", "spacing = 0.01", "scene.toml:14:11: lattice: bodies ",
                "give a spacing of at least 0.02 m");
  refused_scene("duration = 1e-4", "duration = 1e300", "scene.toml:5:12: 1e+300 s takes ",
                "for at most 1e+12 steps");
  refused_scene("[3, 3]", "[30000, 30000]", "scene.toml:14:38: 9e+08 bodies need about ", "");
}

TEST_CASE("a mass of zero is refused", "[tools]") {
  const Workspace w(
      with(discs, "[[boundary]]", "[[particle]]\nradius = 1\nmass = 0\nposition = [5, 5]\n[[boundary]]"));
  check_refused(w, w.run(), "scene.toml:19:8: particle.mass = 0 kg is zero; ", "give a mass above 0");
}

TEST_CASE("a file that is not a scenario is refused", "[tools]") {
  for (const auto& [text, begin, end] :
       {std::array{"", "scene.toml:1:1: the file holds no key; ",
                   "write a scene: [scene], [time], [particles], ..."},
        std::array{"[time\n",
                   "scene.toml:1:6: not valid TOML: ", "write [name] or [[name]] on a line of its own"},
        std::array{"[time]\nstep = 1\n", "scene.toml:1:1: the scene has no [[material]]; ",
                   "add [[material]] with name and density (kg/m^3)"},
        std::array{"[[material]]\nname = 'a'\ndensity = 1\n", "scene.toml:1:1: the scene has no bodies; ",
                   "add [particles] with lattice and radius, random, file or state, or [[particle]]"}}) {
    const Workspace w(text);
    check_refused(w, w.run(), begin, end);
  }
  const Workspace w;
  check_refused(w, w.scree("run scen.toml --out out"),
                "scen.toml: cannot be read (No such file or directory); ", "did you mean 'scene.toml'?");
  refused_scene("[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 0\n",
                "", "scene.toml:1:1: no [[contact]] applies to 'grain' and 'grain'; ",
                "\"hertz_mindlin\" or \"linear_spring_dashpot\" or \"sphere_path_independent\"");
  refused_scene("[time]\nstep = 1e-5\nduration = 1e-4\n", "", "scene.toml:1:1: the file has no 'time'; ",
                "add a table [time]");
}

TEST_CASE("invalid options are reported in one line", "[tools]") {
  refused_options("--threads 0", "--threads: ", "; see scree run --help");
  refused_options("--threads many", "--threads: ", "; see scree run --help");
  refused_options("--thread 2", "unknown option '--thread'; did you mean '--threads'? ",
                  "see scree run --help");
  refused_options("--frobnicate", "The following argument was not expected: --frobnicate",
                  "; see scree run --help");
  refused_options("'--two\nlines'", "The following argument was not expected: --two\\nlines",
                  "; see scree run --help");
  refused_options("--set time.step", "--set time.step: has no '='; ", "write --set key=value");
  refused_options("--set time.stp=1", "--set time.stp=1: unknown key 'stp' in [time]; did you mean 'step'? ",
                  "step, step_guard, expected_speed, energy_audit, integrator, duration");
  refused_options("--plugins nowhere", "--plugins nowhere: is not a directory; ",
                  "boundary/, body_force/, probe/");
  const Workspace w;
  check_refused(w, w.scree("rn scene.toml"), "unknown command 'rn'; ", "did you mean 'run'?");
  check_refused(w, w.scree("run"), "scenario is required; ", "see scree run --help");
  check_refused(w, w.scree(""), "A subcommand is required; ", "see scree --help");
}

TEST_CASE("files of another kind are named with the command that takes them", "[tools]") {
  const Workspace w;
  w.write("many.toml", "[campaign]\nscenario = 'scene.toml'\nseeds = [1]\n");
  for (const char* verb : {"run many.toml --out out", "check many.toml", "modes many.toml --out out"})
    check_refused(w, w.scree(verb), "many.toml:1:1: the file is a campaign, not a scenario; ",
                  "scree campaign many.toml");
  w.write("series.csv", "time [s],x\n0,1\n");
  check_refused(w, w.scree("spectrum series.csv --out out"), "series.csv: is a time series; ",
                "--csv series.csv --column NAME");
  REQUIRE(w.scree("campaign many.toml --out several --quiet").status == 0);
  const Outcome resumed = w.scree("resume several");
  CHECK(resumed.status == 2);
  CHECK(resumed.err.find("several: holds a campaign; repeat scree campaign with its file") !=
        std::string::npos);
}

TEST_CASE("output that cannot be written is refused before the run", "[tools]") {
  const Workspace w;
  w.write("file", "mine");
  check_refused(w, w.scree("run scene.toml --out file"), "file: exists and is not a directory; ",
                "give another --out");
  check_refused(w, w.scree("run scene.toml --out file/out"), "file/out: cannot be written (",
                "give another --out");
  check_refused(w, w.scree("run scene.toml --out /proc/scree"), "/proc/scree: cannot be ",
                "give another --out");
  fs::create_directory(w / "mine");
  w.write("mine/letter.txt", "dear");
  check_refused(w, w.scree("run scene.toml --out mine --overwrite"),
                "mine: contains files that are not part of a scree run; ", "give another --out");
  CHECK(w.text("file") == "mine");
  CHECK(w.text("mine/letter.txt") == "dear");
}

TEST_CASE("an existing run is kept unless --overwrite is given", "[tools]") {
  const Workspace w;
  REQUIRE(w.run("--set scene.seed=1").status == 0);
  const std::string before = w.text("out/run.json");
  const Outcome again = w.run("--set scene.seed=2");
  CHECK(again.status == 2);
  CHECK(again.err ==
        "scree: out: already contains a run; give another --out, or --overwrite to replace it\n");
  CHECK(w.text("out/run.json") == before);
  CHECK(w.run("--overwrite --set time.step=0").status == 2);
  CHECK(w.text("out/run.json") == before);
  CHECK(w.run("--overwrite --set scene.seed=2").status == 0);
  CHECK(w.record()["seed"] == 2);
}

TEST_CASE("a run does not replace the files that its scene reads", "[tools]") {
  const Workspace w;
  REQUIRE(w.run().status == 0);
  w.write("again.toml", with(discs,
                             "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                             "random_velocity = 0.1\n",
                             "file = 'out/final_packing.csv'\n"));
  const std::string before = w.text("out/final_packing.csv");
  for (const char* scene : {"again.toml", "out/scenario.toml"}) {
    const Outcome outcome = w.scree(std::string("run ") + scene + " --out out --overwrite");
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(
              "is read by this scene and a file of the run in out, which would be removed first; copy it "
              "elsewhere, or give another --out\n") != std::string::npos);
  }
  CHECK(w.text("out/final_packing.csv") == before);
  CHECK(w.record()["status"] == "finished");
}

TEST_CASE("everything in the directory of a run is listed, and replaced by the next", "[tools]") {
  const Workspace w(std::string(discs) + "[[chart]]\nname = 'work'\nprobe = 'energy'\ny = 'work'\n" +
                    (SCREE_TEST_PICTURES ? "[snapshot]\nevery = 5e-5\nimage_every = 5e-5\n" : ""));
  REQUIRE(w.run().status == 0);
  const std::string list = w.text("out/written.txt");
  for (const auto& entry : fs::recursive_directory_iterator(w / "out"))
    if (const auto name = fs::relative(entry.path(), w / "out").string();
        name != "written.txt" && !entry.is_directory())
      CHECK(("\n" + list).find("\n" + name + "\n") != std::string::npos);
  w.write("out/series/mine.csv", "mine");
  CHECK(w.run("--overwrite --set chart=[] --set snapshot={}").status == 0);
  CHECK(w.text("out/series/mine.csv") == "mine");
  for (const char* gone : {"out/charts", "out/images", "out/snapshots"}) CHECK_FALSE(w.has(gone));
}

// A limit on file sizes simulates a full disk; a block has 512 bytes.
TEST_CASE("a disk too full for the first file leaves nothing behind", "[tools]") {
  const Workspace w;
  const Outcome full = w.shell("ulimit -f 2; scree run scene.toml --out out/deep");
  CHECK(full.status == 1);
  CHECK(
      full.err ==
      "scree: out/deep/run.json: cannot be written (it would be too large); raise the limit (ulimit -f) or sample less "
      "often\n");
  CHECK_FALSE(w.has("out"));
}

TEST_CASE("a disk that fills up stops the run and keeps the files written before", "[tools]") {
  const Workspace w;
  const Outcome full = w.shell(
      "ulimit -f 16; scree run scene.toml --out out "
      "--set probe.every=1e-5 --set time.duration=0.02 --quiet");
  CHECK(full.status == 1);
  CHECK(full.err ==
        "scree: out/series/energy.csv: cannot be written (it would be too large); "
        "raise the limit (ulimit -f) or sample less often\n");
  CHECK(w.record()["status"] == "failed");
  const std::string series = w.text("out/series/energy.csv");
  CHECK(series.ends_with('\n'));
  const std::size_t cut = 16 * 512 - series.size(),
                    longest = 500;  // a row has 15 numbers of up to 25 characters
  CHECK(cut < longest);
}

// On a file system of its own in memory, as "disk", where this is allowed; status 77 where not. Afterwards it
// is in "out".
static Outcome on_small_disk(const Workspace& w, const std::string& size, const std::string& arguments) {
  return w.shell(
      "mkdir -p out disk\nunshare -m true 2> no || exit 77\nexec unshare -m sh -c '"
      "mount -t tmpfs -o size=" +
      size +
      " none disk || exit 77\n"
      "\"" SCREE_TEST_PROGRAM "\" " +
      arguments +
      "\n"
      "status=$?; cp -a disk/. out; exit $status'");
}

TEST_CASE("a full disk leaves a spectrum that is told to have failed", "[tools]") {
  const Workspace w(text_of(SCREE_TEST_SOURCE "/scenarios/sound/chain.toml"));
  // Something else fills the disk once the sweep has begun.
  const Outcome full = on_small_disk(
      w, "2M",
      "spectrum scene.toml --by sweep --out disk/spectrum --set spectrum.step_hz=0.02 --quiet &\n"
      "until test -e disk/spectrum/sweep.csv; do sleep 0.01; done; cat /dev/zero > disk/more 2> no; wait $!");
  if (full.status == 77) return;
  INFO(full.err);
  CHECK(full.status == 1);
  CHECK_THAT(full.err, Catch::Contains("cannot be written"));
  CHECK(w.record("out/spectrum", "spectrum.json")["status"] == "failed");
  CHECK_FALSE(w.has("out/spectrum/.room"));
}

TEST_CASE("a full disk leaves a quasi-static load that is told to have failed, and goes on", "[tools]") {
  const Workspace w(text_of(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml"));
  // Something else fills the disk once the load is followed; then it is gone.
  const Outcome full = on_small_disk(
      w, "2M",
      "quasi-static scene.toml --set scene.seed=12 --set stage.cycles.cycles=300 --out disk/load --quiet &\n"
      "until test -e disk/load/state.h5; do sleep 0.01; done; cat /dev/zero > disk/more 2> no; wait $!; status=$?\n"
      "grep -q failed disk/load/quasi_static.json && test ! -e disk/load/.room && echo failed\n"
      "rm disk/more; \"" SCREE_TEST_PROGRAM "\" resume disk/load --quiet; (exit $status)");
  if (full.status == 77) return;
  INFO(full.err);
  CHECK(full.status == 1);
  CHECK_THAT(full.err, Catch::Contains("quasi_static.csv: cannot be written; free disk space"));
  CHECK_THAT(full.out, Catch::StartsWith("failed\n"));
  CHECK(w.record("out/load", "quasi_static.json")["status"] == "finished");
  fs::remove_all(w / "out");
  for (const char* call : {"quasi-static scene.toml", "modes scene.toml --modes 5"}) {
    const Outcome tiny = on_small_disk(w, "40k", std::string(call) + " --out disk/load --quiet");
    CHECK(tiny.status == 1);
    CHECK_THAT(tiny.err, Catch::EndsWith(
                             "disk/load/.room: cannot be written; free disk space, or give another --out\n"));
    CHECK(fs::is_empty(w / "out"));
  }
}

TEST_CASE("a full disk leaves a run that is told to have failed, and whole files", "[tools]") {
  const Workspace w;
  const auto run_on_disk = [&](const std::string& size, const std::string& options) {
    return on_small_disk(w, size, "run scene.toml --out disk/run " + options);
  };
  const Outcome full = run_on_disk("300k", "--set probe.every=1e-5 --set time.duration=0.2 --quiet");
  if (full.status == 77) return;
  CHECK(full.status == 1);
  CHECK(full.err ==
        "scree: disk/run/series/energy.csv: cannot be written; free disk space, or give another --out\n");
  CHECK(w.record("out/run")["status"] == "failed");
  CHECK(w.record("out/run")["error"] == full.err.substr(7, full.err.size() - 8));
  CHECK(w.record("out/run")["steps"] > 10);
  CHECK(w.text("out/run/series/energy.csv").ends_with('\n'));
  CHECK_FALSE(w.has("out/run/.room"));
  CHECK_THAT(w.text("out/run/final_packing.csv"), Catch::Contains("# time [s]: "));
  fs::remove_all(w / "out");
  // One that goes on cannot take another directory, not even where it begins anew.
  const std::string again = "; \"" SCREE_TEST_PROGRAM "\" resume disk/run --overwrite --quiet";
  const Outcome resumed =
      run_on_disk("300k", "--set probe.every=1e-5 --set time.duration=0.2 --quiet 2> /dev/null" + again);
  CHECK(resumed.status == 1);
  CHECK(resumed.err.ends_with("scree: disk/run/series/energy.csv: cannot be written; free disk space\n"));
  CHECK(w.record("out/run")["error"] == "disk/run/series/energy.csv: cannot be written; free disk space");
  fs::remove_all(w / "out");
  const Outcome tiny = run_on_disk("40k", "");
  CHECK(tiny.status == 1);
  CHECK(tiny.err == "scree: disk/run/.room: cannot be written; free disk space, or give another --out\n");
  CHECK(fs::is_empty(w / "out"));
}

TEST_CASE("more probes than files can be open are refused, and nothing is left behind", "[tools]") {
  std::string scene = discs;
  for (int k = 0; k < 100; ++k)
    scene += "[[probe]]\nplugin = 'momentum'\nname = 'p" + std::to_string(k) + "'\nevery = 1e-4\n";
  const Workspace w(scene);
  const Outcome outcome = w.shell("ulimit -n 64; scree run scene.toml --out out");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find(
            ".csv: cannot be written (too many files are open); use fewer probes, or raise the limit "
            "(ulimit -n)\n") != std::string::npos);
  CHECK_FALSE(w.has("out"));
}

TEST_CASE("bodies with more close pairs than fit into memory are refused", "[tools]") {
  std::string bodies = "x,y,radius\n";
  for (int k = 0; k < 4000; ++k) bodies += "0,0,0.001\n";
  const Workspace w(with(discs,
                         "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                         "random_velocity = 0.1\n",
                         "file = 'same.csv'\n"));
  w.write("same.csv", bodies);
  check_refused(
      w, w.shell("ulimit -v 800000; scree check scene.toml"),
      "scene.toml:13:1: there are more than 4.1e+06 pairs of bodies nearer than the skin of 0.0001 m, as many "
      "as fit into 0.819 GB of memory; ",
      "place the bodies apart, or give a smaller neighbours.skin");
}
