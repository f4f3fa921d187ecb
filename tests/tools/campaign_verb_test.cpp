#include "campaign_workspace.hpp"

#include <sstream>

using namespace scree::test;

namespace {

// Cells of a column, counted from 0 after the quoted name of the run.
std::vector<std::string> column(const std::string& csv, std::size_t number) {
  std::istringstream stream(csv);
  std::vector<std::string> cells;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream rest(line.substr(line.rfind('"') + 2));
    std::string cell;
    for (std::size_t k = 0; k <= number; ++k) std::getline(rest, cell, ',');
    cells.push_back(cell);
  }
  return cells;
}

using Cells = std::vector<std::string>;

const std::string two_by_two = "seeds = [1, 2]\n[set]\ntime.duration = [1e-4, 2e-4]\n";

}  // namespace

TEST_CASE("a campaign runs every point and collects the results", "[tools]") {
  const CampaignWorkspace w(two_by_two);
  const Outcome outcome = w.scree(campaign_call + "--jobs 2");
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "campaign: 4 runs, 2 values of time.duration x 2 seeds\n4 finished\n"));
  CHECK(contains(outcome.out, "results in out: report.html, table.csv, means.csv, "));
  const std::string table = w.text("out/table.csv");
  CHECK(table.starts_with(
      "run,time.duration,seed,status,expectations,expectations_met,warnings,threads,step,"));
  CHECK(column(table, 0) == Cells{"0.0001", "0.0001", "0.0002", "0.0002"});
  CHECK(column(table, 1) == Cells{"1", "2", "1", "2"});
  CHECK(column(table, 2) == Cells(4, "finished"));
  CHECK(w.record("out/duration=0.0001,seed=2")["seed"] == 2);
  CHECK(w.record("out/duration=0.0002,seed=1")["steps"] == 20);
  CHECK(contains(w.text("out/duration=0.0002,seed=1/log.txt"), "state hash "));
  CHECK(w.text("out/means.csv").starts_with("time.duration,runs,threads_mean,threads_standard_error,"));
  CHECK(nlohmann::json::parse(w.text("out/campaign.json"))["runs"].size() == 4);
}

TEST_CASE("a run of a campaign has the same bits as the same single run", "[tools]") {
  const CampaignWorkspace w(two_by_two);
  REQUIRE(w.scree(campaign_call).status == 0);
  REQUIRE(w.scree("run scene.toml --out hand --set time.duration=2e-4 --set scene.seed=2").status == 0);
  CHECK(w.record("hand")["state_hash"] == w.record("out/duration=0.0002,seed=2")["state_hash"]);
}

TEST_CASE("several campaigns are run by one call, and checked before the first begins", "[tools]") {
  const CampaignWorkspace w(two_by_two);
  std::filesystem::create_directory(w / "more");
  w.write("more/other.toml",
          "[campaign]\nscenario = '../scene.toml'\nseeds = [3]\n[set]\ntime.duration = 1e-4\n");
  const Outcome outcome = w.scree("campaign campaign.toml more/other.toml --out out --quiet");
  INFO(outcome.err << outcome.out);
  CHECK(outcome.status == 0);
  CHECK(w.has("out/campaign/table.csv"));
  CHECK(w.record("out/other/seed=3")["seed"] == 3);
  CHECK(contains(w.scree("campaign campaign.toml more/other.toml --out out").out,
                 "1 of them in an earlier call"));

  w.write("more/campaign.toml", "[campaign]\nscenario = '../scene.toml'\nseeds = [3]\n");
  const auto refused = [&](const std::string& files, const std::string& problem) {
    const Outcome bad = w.scree("campaign campaign.toml " + files + " --out bad");
    INFO(bad.err);
    CHECK(bad.status == 2);
    CHECK(contains(bad.err, problem));
    CHECK_FALSE(w.has("bad"));
  };
  refused("more/campaign.toml",
          "campaign.toml and more/campaign.toml have the same directory, bad/campaign; rename one");
  refused("none.toml", "none.toml");
  // Keys of runs, and a directory that cannot be used.
  w.write("more/key.toml", "[campaign]\nscenario = '../scene.toml'\nseeds = [3]\n[set]\ntime.duratio = 1\n");
  refused("more/key.toml", "unknown key 'duratio'");
  w.write("bad", "mine");
  const Outcome bad = w.scree("campaign campaign.toml more/other.toml --out bad");
  CHECK(bad.status == 2);
  CHECK(contains(bad.err, "bad/campaign: cannot be "));
}

TEST_CASE("finished runs are not repeated, a changed value repeats only its runs", "[tools]") {
  const CampaignWorkspace w(two_by_two);
  REQUIRE(w.scree(campaign_call).status == 0);
  const auto wall = [&](const std::string& run) { return w.record("out/" + run)["wall_s"].get<double>(); };
  const double before = wall("duration=0.0001,seed=1");
  std::filesystem::remove_all(w / "out/duration=0.0001,seed=2");
  w.write("campaign.toml",
          "[campaign]\nscenario = 'scene.toml'\nseeds = [1, 2]\n[set]\ntime.duration = [1e-4, 3e-4]\n");
  const Outcome list = w.scree(campaign_call + "--list");
  CHECK(list.status == 0);
  CHECK(list.out ==
        "campaign: 4 runs, 2 values of time.duration x 2 seeds\n"
        "finished     duration=0.0001,seed=1\n"
        "missing      duration=0.0001,seed=2\n"
        "missing      duration=0.0003,seed=1\n"
        "missing      duration=0.0003,seed=2\n"
        "2 runs with values no longer in the campaign, not in the tables: duration=0.0002,seed=1  "
        "duration=0.0002,seed=2\n");
  CHECK_FALSE(w.has("out/duration=0.0003,seed=1"));
  const Outcome again = w.scree(campaign_call + "--quiet");
  CHECK(contains(again.out, "4 finished (1 of them in an earlier call)\n"));
  CHECK(wall("duration=0.0001,seed=1") == before);
  w.write("scene.toml", with(discs, "random_velocity = 0.1", "random_velocity = 0.2"));
  CHECK(contains(w.scree(campaign_call + "--list").out, "changed      duration=0.0003,seed=2\n"));
  CHECK(contains(w.scree(campaign_call).out, "\n4 finished\n"));
  CHECK(contains(w.scree(campaign_call + "--overwrite").out, "\n4 finished\n"));
}

TEST_CASE("campaign --list refuses what the campaign would refuse", "[tools]") {
  for (const char* set : {"[set]\nparticles.random_velocty = [0.1, 0.2]\n", "[[set]]\na = 1\n"}) {
    const CampaignWorkspace w(set);
    const Outcome run = w.scree(campaign_call), list = w.scree(campaign_call + "--list");
    CHECK(run.status == 2);
    CHECK(list.status == 2);
    CHECK(list.err == run.err);
    CHECK(list.out.empty());
    CHECK_FALSE(w.has("out"));
  }
}

// A limit on file sizes simulates a full disk; a block has 512 bytes.
TEST_CASE("a campaign whose runs cannot be written has failed, and none has blown up", "[tools]") {
  const CampaignWorkspace w("[set]\ntime.duration = [1e-4, 0.02]\nprobe.every = 1e-5\n");
  const Outcome outcome = w.shell("ulimit -f 300; scree " + campaign_call + "--jobs 1");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "\n1 finished, 1 failed\n"));
  CHECK(contains(outcome.out, "energy.csv: cannot be written (it would be too large)"));
}

TEST_CASE("a failed run does not stop the others and is reported with its reason", "[tools]") {
  const CampaignWorkspace w(
      "[set]\n\"time.step_guard\" = false\ntime.duration = 0.1\nparticles.random_velocity = [50, 0.1]\n");
  const Outcome outcome = w.scree(campaign_call + "--jobs 1");
  CHECK(outcome.status == 3);
  CHECK(contains(outcome.out, "\n1 finished, 1 failed\n"));
  CHECK(contains(outcome.out, "FAILED   random_velocity=50: contact of particle "));
  CHECK(contains(w.text("out/table.csv"), "random_velocity=50,50,,failed,,,"));
  CHECK(contains(w.text("out/table.csv"), "random_velocity=0.1,0.1,1,finished,"));
  CHECK(contains(w.scree(campaign_call + "--list").out,
                 "failed       random_velocity=50: contact of particle "));
}

TEST_CASE("an expectation not met by all runs is reported and gives status 1", "[tools]") {
  const CampaignWorkspace w(
      two_by_two,
      std::string(discs) + "[[expect]]\nrequirement = 'Short'\nquantity = 'steps'\nat_most = 10\n");
  const Outcome outcome = w.scree(campaign_call);
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "NOT MET  in 2 of 4: Short\n"));
  CHECK(column(w.text("out/table.csv"), 4) == Cells{"1", "1", "0", "0"});
}

TEST_CASE("nothing is written if any run is refused", "[tools]") {
  const CampaignWorkspace w("[set]\ncontact.normal_stiffness = [1e4, 0]\n");
  check_refused(w, w.scree(campaign_call), "campaign.toml:4:34: in run 'normal_stiffness=0' --set ",
                "give a number above 0 (N/m)");
  check_refused(w, w.scree("campaign scene.toml --out out"), "scene.toml:1:1: the file has no 'campaign'; ",
                "add a table [campaign]");
  check_refused(w, w.scree(campaign_call + "--jobs 0"), "--jobs: ", "see scree campaign --help");
}

TEST_CASE("after Ctrl-C runs are saved, the table is written, and the same command continues", "[tools]") {
  const std::string rest = "[set]\ntime.duration = [1e-4, 5000, 6000]\n";
  const CampaignWorkspace w(rest);
  const Outcome outcome = w.shell("'" SCREE_TEST_PROGRAM
                                  "' campaign campaign.toml --out out --jobs 1 &\nrun=$!\n"
                                  "until test -s out/duration=5000/series/energy.csv; do sleep 0.05; done\n"
                                  "scree campaign campaign.toml --out out --list\n"
                                  "scree campaign campaign.toml --out out; echo second $?\n"
                                  "kill -TERM $run; wait $run");
  INFO(outcome.out);
  CHECK(outcome.status == 130);
  CHECK(contains(outcome.out, "running      duration=5000\nmissing      duration=6000\n"));
  CHECK(contains(outcome.out, "second 2\n"));
  CHECK(outcome.err == "scree: out: another campaign is running there; wait for it, or give another --out\n");
  CHECK(contains(outcome.out, "\n1 finished, 2 to do\n"));
  CHECK(contains(outcome.out, "interrupted; run the same command again to continue\n"));
  CHECK(w.record("out/duration=5000")["status"] == "interrupted");
  CHECK(contains(w.text("out/table.csv"), "\nduration=5000,5000,,interrupted,"));
  w.write("scene.toml", with(discs, "step = 1e-5", "step = 1e-5\n"));
  CHECK(w.scree(campaign_call + "--list").out ==
        "campaign: 3 runs, 3 values of time.duration\n"
        "finished     duration=0.0001\ninterrupted  duration=5000\nmissing      duration=6000\n");
}

TEST_CASE("runs end when their campaign is killed", "[tools]") {
  const CampaignWorkspace w("[set]\ntime.duration = [5000]\n");
  const Outcome outcome =
      w.shell("'" SCREE_TEST_PROGRAM
              "' campaign campaign.toml --out out &\nrun=$!\n"
              "until test -s out/duration=5000/series/energy.csv; do sleep 0.05; done\n"
              "kill -KILL $run; wait $run\n"
              "until scree campaign campaign.toml --out out --list | grep interrupted; do\n"
              "  sleep 0.05; done");
  CHECK(outcome.out.ends_with("interrupted  duration=5000\n"));
}

TEST_CASE("without --out a campaign uses its own directory and continues there", "[tools]") {
  const CampaignWorkspace w("");
  CHECK(contains(w.scree("campaign campaign.toml").out, "results in campaigns/campaign: "));
  CHECK(w.record("campaigns/campaign/run")["status"] == "finished");
  CHECK(contains(w.scree("campaign campaign.toml").out, "1 finished (1 of them in an earlier call)\n"));
}

TEST_CASE("a directory with other files is not changed", "[tools]") {
  const CampaignWorkspace w("");
  REQUIRE(w.run().status == 0);
  const Outcome outcome = w.scree(campaign_call + "--overwrite");
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "scree: out: contains files that are not part of a scree campaign; give another --out\n");
  CHECK(w.record()["status"] == "finished");
}

TEST_CASE("files in the directory of a run are not changed", "[tools]") {
  const CampaignWorkspace w("");
  REQUIRE(w.scree(campaign_call).status == 0);
  std::filesystem::remove(w / "out/run/run.json");
  std::filesystem::remove(w / "out/run/written.txt");
  const Outcome outcome = w.scree(campaign_call);
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "scree: out/run: contains files that are not part of a scree run; give another --out\n");
  CHECK(w.has("out/run/series/energy.csv"));
}

TEST_CASE("a campaign tells of warnings of its runs", "[tools]") {
  // 12 steps in the shortest contact of the second.
  const CampaignWorkspace w("[set]\ncontact.normal_stiffness = [1e4, 1e8]\n");
  const Outcome outcome = w.scree(campaign_call);
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "WARNINGS in 1 of 2 runs, see the column warnings of table.csv; "));
  CHECK(contains(w.text("out/table.csv"), ",\"the shortest contact takes "));
}

TEST_CASE("a campaign with a pipe or an option-like name as scenario, or with a folder in its way",
          "[tools]") {
  const CampaignWorkspace w("");
  w.write("pipe.toml", "[campaign]\nscenario = 'fifo'\n");
  const Outcome pipe =
      w.shell("mkfifo fifo; exec timeout 20 '" SCREE_TEST_PROGRAM "' campaign pipe.toml --out out");
  check_refused(w, pipe, "pipe.toml:2:12: fifo is not a regular file; ", "read several times");
  w.write("-x.toml", discs);
  w.write("dash.toml", "[campaign]\nscenario = '-x.toml'\n");
  CHECK(w.scree("campaign dash.toml --out dash").status == 0);
  const Outcome folder = w.shell("mkdir -p out/campaign.json; scree " + campaign_call);
  CHECK(folder.status == 2);
  CHECK(contains(folder.err, "out/campaign.json: is not a file; remove it, or give another --out\n"));
}

TEST_CASE("a campaign that goes on writes through no link in its directory", "[tools]") {
  const CampaignWorkspace w("[set]\ntime.duration = [1e-4, 2e-4]\n");
  REQUIRE(w.scree(campaign_call).status == 0);
  const Outcome outcome = w.shell(
      "for k in 1 2 3 4; do echo mine > precious$k; done\nrun=out/duration=0.0001\n"
      "ln -s ../precious1 out/table.csv.part; ln -s ../precious2 out/campaign.json.part\n"
      "ln -sf ../../precious3 $run/log.txt; ln -s ../../precious4 $run/run.json.part\n"
      "scree campaign campaign.toml --out out --overwrite || exit 1; cat precious?\n"
      "mkdir elsewhere; mv out/duration=0.0002 elsewhere/run; ln -s ../elsewhere/run out/duration=0.0002\n"
      "rm elsewhere/run/run.json; scree campaign campaign.toml --out out");
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.out, "mine\nmine\nmine\nmine\n"));
  CHECK(
      outcome.err ==
      "scree: out/duration=0.0002: is a symbolic link, which is not followed; remove it, or give another --out\n");
  CHECK_FALSE(w.has("elsewhere/run/run.json"));
}
