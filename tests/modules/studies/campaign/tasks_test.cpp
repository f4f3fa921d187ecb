#include "campaign_support.hpp"

#include <atomic>

#include <catch2/catch.hpp>

#include <scree/campaign/gather.hpp>
#include <scree/campaign/tasks.hpp>
#include <scree/files/directory_lock.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::make_run;

namespace {

// A campaign with the list of its tasks, of which none can be run: there is no program to run them.
struct Listed {
  explicit Listed(const std::string& rest, std::size_t per_task = 1) : folder(rest), campaign(folder.read()) {
    options.program = "/no/such/program";
    const CampaignDirectory directory(out(), campaign, true);
    directory.files().write_file("campaign.json", "{}");
    numbers = list_tasks(
        campaign, directory, per_task, [](const Point&) { return true; }, test::host());
  }
  std::filesystem::path out() const { return folder.folder() / "out"; }
  Execution run(std::size_t number, const TaskOptions& task = {}) const {
    CampaignDirectory directory(out(), campaign, false);
    return run_task(campaign, directory, number, options, task, test::host());
  }
  void set_status(const std::string& run, const std::string& status) const {
    const std::string path = "out/" + run + "/run.json", text = test::text_of(folder.folder() / path);
    folder.folder().write(path, test::with(text, "\"finished\"", "\"" + status + "\""));
  }

  CampaignFolder folder;
  Campaign campaign;
  ExecutionOptions options;
  TaskNumbers numbers;
};

}  // namespace

TEST_CASE("a task whose runs have finished does nothing", "[tasks]") {
  const Listed list("seeds = [1, 2, 3]\n", 2);
  REQUIRE(list.numbers.points == std::vector<std::vector<std::size_t>>{{0, 1}});
  for (const std::size_t k : {0, 1}) make_run(list.campaign, k, list.out() / list.campaign.points[k].name);
  const Execution done = list.run(0);
  CHECK(done.count(Status::finished) == 2);
  CHECK(done.finished_before == 2);
  CHECK(list.run(1).count(Status::failed) == 1);  // without a program
  CHECK_THROWS_WITH(list.run(2),
                    Catch::EndsWith("has tasks 0 to 1, and no task 2; print them with --print-tasks, "
                                    "or submit them with --on slurm"));
}

TEST_CASE("a task of a campaign that changed since it was listed is refused", "[tasks]") {
  Listed list("seeds = [1, 2]\n");
  const std::string cure = " changed since it was submitted; repeat the command";
  list.campaign = list.folder.read({"campaign.seeds=[2, 3]"});
  CHECK_THROWS_WITH(list.run(0), Catch::EndsWith("campaign.toml: seed=1" + cure));
  CHECK_NOTHROW(list.run(1));
  list.folder.folder().write("scene.toml",
                             test::with(test::discs, "normal_damping = 0", "normal_damping = 1"));
  CHECK_THROWS_WITH(list.run(1), Catch::EndsWith("campaign.toml: seed=2" + cure));
}

TEST_CASE("a task waits for another process that still writes its run, and gives up in time", "[tasks]") {
  const Listed list("seeds = [1]\n");
  const auto lock = files::DirectoryLock::take(list.out() / "seed=1");
  REQUIRE(lock);
  CHECK_THROWS_WITH(
      list.run(0, {.patience = 0.1}),
      Catch::EndsWith("seed=1: another process is writing there; wait for it, or end it, and repeat "
                      "the command"));
}

TEST_CASE("a run that is stopped again and again before a step has failed", "[tasks]") {
  const std::atomic<bool> stop = true;
  Listed list("seeds = [1]\n");
  list.options.stop = &stop;
  make_run(list.campaign, 0, list.out() / "seed=1");
  list.set_status("seed=1", "interrupted");
  CHECK(list.run(0, {.restarts = 2}).interrupted);
  CHECK_THROWS_WITH(list.run(0, {.restarts = 3}),
                    Catch::Contains("seed=1: was stopped before its first further step, after 3 restarts; "
                                    "its limit of time is shorter than its start; give a longer --time"));
}

TEST_CASE("gathering tells what runs have become, whoever ran them", "[tasks]") {
  const Listed list("seeds = [1, 2, 3, 4]\n");
  for (const std::size_t k : {0, 1, 2}) make_run(list.campaign, k, list.out() / list.campaign.points[k].name);
  // Killed, as by the lack of memory, and refused before it had a record.
  list.set_status("seed=2", "running");
  list.folder.folder().write("out/seed=2/log.txt", " 42 %  0:10 left\nsome words\n");
  list.set_status("seed=3", "running");
  std::filesystem::create_directory(list.out() / "seed=4");
  list.folder.folder().write("out/seed=4/log.txt", "scree: scene.toml:4:8: a reason; a cure\n");
  const auto lock = files::DirectoryLock::take(list.out() / "seed=3");
  const Execution now =
      gathered(list.campaign, CampaignDirectory(list.out(), list.campaign, false), test::host());
  CHECK(now.outcomes[0].status == Status::finished);
  CHECK(now.outcomes[1].status == Status::interrupted);
  CHECK(now.outcomes[1].problem == "some words");
  CHECK(now.outcomes[2].status == Status::running);
  CHECK(now.outcomes[3].status == Status::failed);
  CHECK(now.outcomes[3].problem == "scene.toml:4:8: a reason; a cure");
  CHECK_FALSE(now.blew_up);
}

TEST_CASE("words are quoted for a shell where it is needed", "[tasks]") {
  CHECK(shell_line({"/bin/scree", "--set", "a.b=[1, 2]", "it's", ""}) ==
        "/bin/scree --set 'a.b=[1, 2]' 'it'\\''s' ''");
}
