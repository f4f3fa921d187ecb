#include "program.hpp"

using namespace scree::test;

namespace {

const std::string sampled = with(discs, "every = 2e-5\n", "every = 1e-5\n");

}  // namespace

TEST_CASE("a run leaves its report, which is listed and replaced with its other files", "[tools]") {
  const Workspace w(sampled);
  const Outcome run = w.run();
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Catch::Contains("out/report.html"));
  const std::string page = w.text("out/report.html");
  CHECK_THAT(page, Catch::Contains("The run finished.") && Catch::Contains("Energies over time") &&
                       Catch::Contains(w.record()["state_hash"].get<std::string>()));
  CHECK_THAT(w.text("out/written.txt"), Catch::Contains("\nreport.html\n"));
  const Outcome again = w.scree("report out");
  CHECK(again.status == 0);
  CHECK(again.out == "out/report.html\n");
  CHECK(w.text("out/report.html") == page);
  CHECK(w.run("--overwrite --set scene.title=another").status == 0);
  CHECK_THAT(w.text("out/report.html"), Catch::Contains("<title>another</title>"));
}

TEST_CASE("a run that failed or was interrupted says so in its report, and one that goes on replaces it",
          "[tools]") {
  const Workspace w;
  CHECK(w.run("--set time.step_guard=false --set particles.random_velocity=50 --set time.duration=0.01")
            .status == 3);
  CHECK_THAT(w.text("out/report.html"), Catch::Contains("The run failed: "));
  const std::string longer = " --set time.duration=1000 --set checkpoint.every='\"never\"' --quiet";
  CHECK(w.shell("timeout --signal=INT 0.5 '" SCREE_TEST_PROGRAM "' run scene.toml --out stopped" + longer)
            .status == 124);
  CHECK_THAT(w.text("stopped/report.html"), Catch::Contains("The run was interrupted before its end."));
  // Killed while it goes on, it has no page of what it was.
  CHECK(w.shell("timeout --signal=KILL 0.5 '" SCREE_TEST_PROGRAM "' resume stopped --quiet").status != 0);
  CHECK_FALSE(w.has("stopped/report.html"));
  CHECK(w.scree("report stopped").status == 0);
  CHECK_THAT(w.text("stopped/report.html"),
             Catch::Contains("The run had not ended when this page was written."));
  CHECK(w.scree("resume stopped --until 1e-3 --quiet").status == 2);
}

TEST_CASE("report writes beside a run that goes on, which then replaces its page", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.shell(
      "'" SCREE_TEST_PROGRAM
      "' run scene.toml --out out --set time.duration=1000 --quiet > log &\n"
      "until [ -e out/run.json ]; do sleep 0.01; done\n"
      "scree report out && grep -c 'had not ended' out/report.html && kill -TERM $! && wait $!; echo $?");
  CHECK(outcome.out == "out/report.html\n1\n130\n");
  CHECK_THAT(w.text("out/report.html"), Catch::Contains("The run was interrupted before its end."));
  const std::string list = w.text("out/written.txt");
  CHECK(list.find("report.html") == list.rfind("report.html"));
}

TEST_CASE("a file of another origin is not replaced by a report", "[tools]") {
  const Workspace w;
  REQUIRE(w.run().status == 0);
  std::filesystem::rename(w / "out/written.txt", w / "out/list");
  w.write("out/report.html", "mine");
  const Outcome foreign = w.scree("report out");
  CHECK(foreign.status == 2);
  CHECK(foreign.err == "scree: out/report.html: is there and was not written by scree; move it elsewhere\n");
  CHECK(w.text("out/report.html") == "mine");
  std::filesystem::remove(w / "out/report.html");
  CHECK(w.scree("report out").status == 0);
  CHECK(w.scree("report out").status == 0);
  CHECK_FALSE(w.has("out/written.txt"));
}

TEST_CASE("a report that cannot be written is a warning", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.shell(
      "scree run scene.toml --out out --set time.duration=2 --quiet & until [ -e out/run.json ]; do sleep 0.01; done\n"
      "mkdir out/report.html && wait $!; echo $?");
  CHECK_THAT(outcome.out, Catch::EndsWith("\n0\n"));
  CHECK_THAT(outcome.err,
             Catch::Contains("scree: warning: report.html is missing: out/report.html: is there and was "
                             "not written by a run; move it elsewhere"));
  CHECK(w.record()["status"] == "finished");
}

TEST_CASE("a campaign leaves its report with links to those of its runs", "[tools]") {
  const Workspace w(sampled);
  w.write(
      "c.toml",
      "[campaign]\nscenario = 'scene.toml'\nseeds = [1, 2]\ncollect = ['energy.kinetic_translation.last']\n[set]\n"
      "'contact.normal_stiffness' = [1e4, 2e4]\n");
  const Outcome outcome = w.scree("campaign c.toml --out c");
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Catch::Contains("results in c: report.html, table.csv, means.csv"));
  const std::string page = w.text("c/report.html");
  CHECK_THAT(page, Catch::Contains("All 4 runs finished.") &&
                       Catch::Contains("energy.kinetic_translation.last over normal_stiffness") &&
                       Catch::Contains("href=\"normal_stiffness=10000,seed=1/report.html\""));
  CHECK(w.has("c/normal_stiffness=10000,seed=1/report.html"));
  w.write("c/report.html", "mine");
  CHECK(w.scree("report c").status == 2);
  const Outcome again = w.scree("campaign c.toml --out c");
  CHECK(again.status == 0);
  CHECK_THAT(again.err,
             Catch::Contains("the report of the campaign is missing: c/report.html: is there and was not "
                             "written by a campaign; move it elsewhere"));
  CHECK(w.text("c/report.html") == "mine");
}

TEST_CASE("report refuses what is no directory of results, and its help has an example", "[tools]") {
  const Workspace w;
  CHECK(w.scree("report .").err ==
        "scree: .: contains no results of scree; give the directory of a run, a study or a campaign\n");
  CHECK(w.scree("report .").status == 2);
  CHECK(w.scree("report none").status == 2);
  CHECK_THAT(w.scree("report --help").out, Catch::Contains("Example: scree report runs/first"));
}
