#include "program.hpp"

using namespace scree::test;

namespace {

const std::string endless_scene = with(discs, "duration = 1e-4", "duration = 5000");

// Starts an endless run in the background, as $run, where a shell has its children ignore Ctrl-C; it is
// killed after 30 s.
const std::string begin_run = "'" SCREE_TEST_PROGRAM
                              "' run scene.toml --out out --quiet &\nrun=$!\n"
                              "(sleep 30; kill -KILL $run) > /dev/null 2>&1 &\ntrap \"kill $!\" EXIT\n"
                              "until test -s out/series/energy.csv; do sleep 0.05; done; sleep 0.1\n";
// The same as in the foreground.
const std::string start_run = "env --default-signal=INT " + begin_run;

void check_saved(const Workspace& w, const Outcome& outcome) {
  INFO(outcome.err);
  CHECK(outcome.status == 130);
  CHECK(outcome.out.find("interrupted; results so far are saved, go on with: scree resume out\n") !=
        std::string::npos);
  CHECK(w.record()["status"] == "interrupted");
  CHECK(w.record()["steps"] > 10);
  CHECK(w.text("out/final_packing.csv").find("# time [s]: ") != std::string::npos);
}

}  // namespace

TEST_CASE("Ctrl-C, the end of a batch job and a closed terminal save the run and give status 130",
          "[tools]") {
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    const Workspace w(endless_scene);
    check_saved(w, w.shell(start_run + "kill -" + signal + " $run; wait $run"));
  }
}

TEST_CASE("signals within a second are one request to save", "[tools]") {
  const Workspace w(endless_scene);
  check_saved(
      w, w.shell(start_run +
                 "for s in TERM TERM TERM INT INT INT HUP HUP TERM INT; do kill -$s $run; done; wait $run"));
  const Workspace limited(endless_scene);
  const Outcome outcome =
      limited.shell("exec timeout 0.7 '" SCREE_TEST_PROGRAM "' run scene.toml --out out --quiet");
  CHECK(outcome.status == 124);  // of timeout itself
  CHECK(limited.record()["status"] == "interrupted");
}

// A pipe that is full holds the program up when it has saved and tells so.
TEST_CASE("a signal again, more than a second later, ends the program at once", "[tools]") {
  for (const std::string again : {"INT", "TERM"}) {
    const Workspace w(endless_scene);
    const Outcome outcome =
        w.shell("mkfifo pipe; exec 3<>pipe; head -c 65536 /dev/zero >&3\nexec 4>&1 >&3\n" + start_run +
                "kill -TERM $run; until grep -q interrupted out/run.json; do sleep 0.05; done\n"
                "sleep 1.1; kill -HUP $run; sleep 0.1; kill -0 $run && echo 'still there' >&4\n"
                "kill -" +
                again + " $run; wait $run");
    CHECK(outcome.status == 130);
    CHECK(outcome.out == "still there\n");
  }
}

// Not even the kernel comes to an end of its step.
TEST_CASE("a signal again ends a run that a plug-in holds", "[tools]") {
  const std::string at_rest =
      with(with(endless_scene, "gap = 0.1", "gap = 0.0"), "random_velocity = 0.1", "random_velocity = 0");
  const Workspace w(with(with(at_rest, "linear_spring_dashpot", "ends_run"),
                         "normal_stiffness = 1e4\nnormal_damping = 0\n", "where = 'holding'\n"));
  const Outcome outcome = w.shell(
      "SCREE_TEST_ENDS_AT=hold; export SCREE_TEST_ENDS_AT; SCREE_PLUGIN_PATH='" SCREE_TEST_BROKEN
      "'; export SCREE_PLUGIN_PATH\n" +
      start_run +
      "touch hold; sleep 0.1; kill -TERM $run; sleep 1.1; kill -0 $run && echo 'still there'; kill -TERM $run; wait $run");
  CHECK(outcome.status == 130);
  CHECK(outcome.out == "still there\n");
  CHECK(w.record()["status"] == "running");
}

TEST_CASE("a run in the background of a script outlives Ctrl-C, which is for the script", "[tools]") {
  const Workspace w(endless_scene);
  check_saved(w, w.shell(begin_run + "kill -INT $run; sleep 0.3; grep -q interrupted out/run.json && exit 1\n"
                                     "kill -TERM $run; wait $run"));
}

TEST_CASE("a run started with nohup outlives its terminal", "[tools]") {
  const Workspace w(endless_scene);
  check_saved(w, w.shell("trap '' HUP\n" + start_run +
                         "kill -HUP $run; sleep 0.3; grep -q interrupted out/run.json && exit 1\n"
                         "kill -INT $run; wait $run"));
}
