#include "program.hpp"

#include <filesystem>

#include <scree/plugin/abi.h>

using namespace scree::test;

namespace {

const std::string broken = SCREE_TEST_BROKEN;
const std::string broken_options = "--plugins '" + broken + "'";

void refused_plugin(const std::string& plugin, const std::string& begin, const std::string& end) {
  const Workspace w(with(discs, "linear_spring_dashpot", plugin));
  check_refused(w, w.run(broken_options), "scene.toml:10:10: " + begin, end);
}

// Discs that touch, with the law ends_run.
std::string scene_that_ends(const std::string& where, const std::string& duration = "duration = 1e-4\n") {
  const std::string touching = with(with(discs, "gap = 0.1", "gap = 0.0"), "duration = 1e-4\n", duration);
  return with(with(touching, "linear_spring_dashpot", "ends_run"),
              "normal_stiffness = 1e4\nnormal_damping = 0\n", "where = '" + where + "'\n");
}

std::string library(const std::string& name) { return broken + "/contact/" + name + ".so: "; }

}  // namespace

TEST_CASE("a missing plug-in is refused with the nearest name", "[tools]") {
  refused_plugin("linear_spring_dashpt",
                 "no contact law plug-in 'linear_spring_dashpt' in " + broken + "/contact, ",
                 "; did you mean 'linear_spring_dashpot'?");
  refused_plugin("gravity", "no contact law plug-in 'gravity' in ", "");
}

TEST_CASE("a plug-in of another interface version is refused by name", "[tools]") {
  refused_plugin("other_version",
                 library("other_version") + "plug-in interface version " +
                     std::to_string(SCREE_ABI_VERSION + 41) + ", this program has " +
                     std::to_string(SCREE_ABI_VERSION) + "; ",
                 "rebuild it against this version");
}

TEST_CASE("a library without the query symbol is refused by name", "[tools]") {
  refused_plugin("no_query", library("no_query") + "lacks the symbol scree_plugin_query; ",
                 "export the plug-in with one of the SCREE_*_PLUGIN macros");
}

TEST_CASE("a text file named as a library is refused by name", "[tools]") {
  refused_plugin("text", library("text") + "not a usable plug-in library (", "); rebuild it");
}

TEST_CASE("broken libraries affect neither other plug-ins nor their list", "[tools]") {
  const Workspace w;
  CHECK(w.run(broken_options).status == 0);
  const Outcome list = w.scree("describe " + broken_options);
  CHECK(list.status == 0);
  for (const char* name : {"other_version", "no_query", "text"})
    CHECK(list.out.find("not usable: " + library(name)) != std::string::npos);
  CHECK(list.out.find("  linear_spring_dashpot ") != std::string::npos);
}

TEST_CASE("plug-ins are also found through the environment", "[tools]") {
  const Workspace w(with(discs, "linear_spring_dashpot", "no_query"));
  const Outcome outcome =
      w.shell("SCREE_PLUGIN_PATH='" + broken + "'; export SCREE_PLUGIN_PATH; scree check scene.toml");
  check_refused(w, outcome, "scene.toml:10:10: " + library("no_query"), "macros");
}

TEST_CASE("a path of plug-ins in the environment that is no directory is refused", "[tools]") {
  const Workspace w;
  check_refused(w, w.shell("SCREE_PLUGIN_PATH=nowhere; export SCREE_PLUGIN_PATH; scree check scene.toml"),
                "SCREE_PLUGIN_PATH: nowhere: is not a directory; ", "boundary/, body_force/, probe/");
}

TEST_CASE("a plug-in that ends the program does not pass for a success", "[tools]") {
  const Workspace w(with(with(discs, "linear_spring_dashpot", "exits_when_configured"),
                         "normal_stiffness = 1e4\nnormal_damping = 0\n", ""));
  const Outcome outcome = w.run(broken_options);
  CHECK(outcome.status != 0);
  CHECK_THAT(outcome.err, Catch::Contains("a plug-in ended the program with exit(); "));
}

TEST_CASE("a plug-in that ends the program at once does not pass for a success", "[tools]") {
  for (const char* where : {"force", "unloading"}) {
    INFO(where);
    const Workspace w(scene_that_ends(where));
    const Outcome outcome = w.run(broken_options);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Contains("a plug-in ended the program with _exit(); "));
  }
}

// Nothing can notice the system call: no state of the record may then pass for a result.
TEST_CASE("a run that a plug-in ends by a system call is not finished, and goes on to the same bits",
          "[tools]") {
  const Workspace w(scene_that_ends("system_call", "duration = 1e-3\n") +
                    "[checkpoint]\nevery_time = 2e-4\n");
  REQUIRE(w.run(broken_options).status == 0);
  std::filesystem::rename(w / "out", w / "whole");
  w.shell(
      "SCREE_TEST_ENDS_AT=out/checkpoint/step_000000000000020.h5; export SCREE_TEST_ENDS_AT\n"
      "scree run scene.toml --out out " +
      broken_options);
  CHECK(w.record()["status"] == "running");
  CHECK(w.scree("resume out " + broken_options).status == 0);
  CHECK(w.record()["status"] == "finished");
  CHECK(w.record()["state_hash"] == w.record("whole")["state_hash"]);
  CHECK(w.text("out/series/energy.csv") == w.text("whole/series/energy.csv"));
}

TEST_CASE("a law that states no step short enough is refused before anything is printed or written",
          "[tools]") {
  for (const bool guard : {true, false}) {
    const Workspace w(with(with(with(discs, "linear_spring_dashpot", "no_step"),
                                "normal_stiffness = 1e4\nnormal_damping = 0\n", ""),
                           "duration = 1e-4\n",
                           guard ? "duration = 1e-4\n" : "duration = 1e-4\nstep_guard = false\n"));
    const Outcome outcome = w.scree("check scene.toml " + broken_options);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
  }
}
