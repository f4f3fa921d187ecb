#include "campaign_support.hpp"
#include "fake_slurm.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/campaign/submission.hpp>
#include <scree/campaign/tasks.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::FakeSlurm;
using test::make_run;

namespace {

const std::string four_seeds = "seeds = [1, 2, 3, 4]\n";
const std::string two_prepared =
    "seeds = [1, 2]\n[set]\n\"contact.normal_stiffness\" = [1e4, 2e4]\n[prepare]\nscenario = 'prepare.toml'\n";

// A campaign of discs that is submitted to its folder `out`.
struct Submitted {
  explicit Submitted(const std::string& rest, const std::string& scene = test::discs) : folder(rest, scene) {
    folder.folder().write("prepare.toml", test::discs);
    options.command = {"scree", "campaign", "campaign.toml"};
  }
  Submission submit(const std::vector<std::string>& overrides = {}) {
    const Campaign c = read(overrides);
    CampaignDirectory directory(out(), c, true);
    options.site = c.slurm;
    return campaign::submit(c, directory, options, {}, test::host());
  }
  std::string refusal() {
    return test::message([&] { submit(); });
  }
  Campaign read(const std::vector<std::string>& overrides = {}) const {
    return branched(folder.read(overrides), test::host());
  }
  std::filesystem::path out() const { return folder.folder() / "out"; }
  std::string text(const std::string& name) const { return test::text_of(out() / name); }
  // What squeue says of elements of an array.
  std::string queued(const std::string& job, std::size_t from, std::size_t to, std::size_t first = 0) const {
    std::string lines;
    for (std::size_t k = from; k <= to; ++k)
      lines += fmt::format("{}|{}|PENDING|Priority|scree tasks from {}\n", job, k, first);
    return lines;
  }

  CampaignFolder folder;
  SubmissionOptions options;
};

const std::string scene_for_states = test::with(
    test::with(test::with(test::discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n", ""),
               "radius = 0.01\n", ""),
    "random_velocity = 0.1\n", "");

}  // namespace

TEST_CASE("a campaign is submitted as one array and a job that gathers", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(
      four_seeds +
      "[slurm]\npartition = 'long'\ntime = '4:00:00'\nmemory = '2G'\noptions = ['--mail-type=END']\n");
  s.options.processors = 6;
  const Submission made = s.submit();
  CHECK(made.runs == 4);
  CHECK(made.jobs == std::vector<std::string>{"101"});
  CHECK(made.gather == "102");
  for (const char* word :
       {"--array=0-3", "--partition=long", "--time=4:00:00", "--mem=2G", "--mail-type=END",
        "--cpus-per-task=6", "--requeue", "--comment=scree tasks from 0", "--signal=TERM@60", "0"}) {
    INFO(word << slurm.call(1));
    CHECK(slurm.has(1, word));
  }
  CHECK(slurm.has(1, "--job-name=" + made.name));
  CHECK(slurm.has(1, "--output=" + s.out().string() + "/tasks/%A_%a.txt"));
  CHECK(slurm.call(1).find("--dependency") == std::string::npos);
  CHECK(slurm.has(2, "--dependency=afterany:101"));
  CHECK(slurm.has(2, s.out().string() + "/tasks/gather.sh"));
  CHECK(s.text("tasks/task.sh").find("scree campaign campaign.toml --task $(($1 + SLURM_ARRAY_TASK_ID))\n") !=
        std::string::npos);
  CHECK(s.text("campaign.json").find("\"missing\"") != std::string::npos);
}

TEST_CASE("nothing of [slurm] is among the inputs of runs", "[slurm]") {
  const CampaignFolder here(""), there("[slurm]\npartition = 'long'\noptions = ['--mem=1G']\n");
  const Campaign a = here.read(), b = there.read({"slurm.time=1:00"});
  CHECK(b.slurm.time == "1:00");
  CHECK(inputs_of(a, a.points[0], test::host()).resolved_text ==
        inputs_of(b, b.points[0], test::host()).resolved_text);
  CHECK(inputs_key(a, a.points[0], test::host()) == inputs_key(b, b.points[0], test::host()));
  CHECK_THAT(test::refusal_of("[slurm]\noptions = ['mem=1G']\n"),
             Catch::StartsWith("campaign.toml:4:12: 'mem=1G' is no option of sbatch; "));
  CHECK_THAT(test::refusal_of("[slurm]\nnodes = 2\n"),
             Catch::StartsWith("campaign.toml:4:1: unknown key 'nodes'"));
}

TEST_CASE("points wait for their preparations, and are cancelled with them", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(two_prepared, scene_for_states);
  CHECK(s.submit().runs == 6);
  REQUIRE(slurm.calls() == 4);
  CHECK(slurm.has(1, "--array=0-1"));
  for (const std::size_t k : {2, 3}) {
    CHECK(slurm.has(k, fmt::format("--dependency=afterok:101_{}", k - 2)));
    CHECK(slurm.has(k, "--kill-on-invalid-dep=yes"));
    CHECK(slurm.has(k, "--array=0-1"));
    CHECK(slurm.has(k, fmt::format("--comment=scree tasks from {}", 2 * k - 2)));
  }
  CHECK(slurm.has(4, "--dependency=afterany:101:102:103"));
  // Preparations that wait are waited for, also by points that are submitted again.
  slurm.write("queue", s.queued("101", 0, 1));
  CHECK(s.submit().runs == 4);
  REQUIRE(slurm.calls() == 7);
  CHECK(slurm.has(5, "--dependency=afterok:101_0"));
  CHECK(slurm.has(6, "--dependency=afterok:101_1"));
  // One that is there is not.
  const Campaign c = s.read();
  slurm.write("queue", "");
  for (const Point& point : c.preparation->points)
    make_run(*c.preparation, std::size_t(&point - c.preparation->points.data()), s.out() / point.name);
  CHECK(s.submit().runs == 4);
  REQUIRE(slurm.calls() == 9);
  CHECK(slurm.has(8, "--array=0-3"));
  CHECK(slurm.call(8).find("--dependency") == std::string::npos);
}

TEST_CASE("arrays are cut where Slurm allows no larger numbers, and runs put together", "[slurm]") {
  const FakeSlurm slurm;
  slurm.write("config", "Configuration data\nMaxArraySize            = 3\nMaxJobCount = 9\n");
  Submitted s("seeds = { first = 1, count = 14 }\n");
  s.options.per_task = 2;
  const Submission made = s.submit();
  CHECK(made.runs == 14);
  CHECK(made.tasks == 7);
  CHECK(made.jobs.size() == 3);
  for (const std::size_t k : {1, 2}) CHECK(slurm.has(k, "--array=0-2"));
  CHECK(slurm.has(3, "--array=0"));
  CHECK(slurm.has(3, "6"));
  CHECK(slurm.has(4, "--dependency=afterany:101:102:103"));
}

TEST_CASE("repeating the command submits what is neither finished nor in the queue", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  s.submit();
  slurm.write("queue", s.queued("101", 1, 2) + "102|N/A|PENDING|Dependency|scree gather\n");
  make_run(s.read(), 0, s.out() / "seed=1");
  const Submission again = s.submit();
  CHECK(again.runs == 1);
  CHECK(again.before == 2);
  CHECK(again.finished == 1);
  CHECK(slurm.has(3, "--array=0"));
  CHECK(slurm.has(3, "3"));  // the task of seed 4
  CHECK(slurm.has(4, "--dependency=afterany:101:103"));
  // Tasks keep their numbers when the campaign has others.
  slurm.write("queue", s.queued("101", 1, 2) + s.queued("103", 0, 0, 3));
  const Submission more = s.submit({"campaign.seeds=[9, 4, 3, 2]"});
  CHECK(more.runs == 1);
  CHECK(slurm.has(5, "4"));
  CHECK(s.submit().runs == 0);
  CHECK(slurm.calls() == 6);
}

TEST_CASE("a run that has changed is submitted again, though its old task still waits", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  CHECK(s.submit().runs == 4);
  slurm.write("queue", s.queued("101", 0, 3));
  CHECK(s.submit().before == 4);
  const Submission changed = s.submit({"contact.normal_stiffness=3e4"});
  CHECK(changed.before == 0);
  CHECK(changed.runs == 4);
}

TEST_CASE("repeating the command while everything is in the queue, preparations too, submits nothing",
          "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(two_prepared, scene_for_states);
  CHECK(s.submit().runs == 6);
  slurm.write("queue", s.queued("101", 0, 1) + s.queued("102", 0, 1, 2) + s.queued("103", 0, 1, 4));
  const Submission again = s.submit();
  CHECK(again.runs == 0);
  CHECK(again.before == 6);
}

TEST_CASE("what a login node submitted before it died is found in the queue", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  s.submit();
  const std::string record = s.text("tasks/jobs.json");
  test::TemporaryFolder const& folder = s.folder.folder();
  folder.write("out/tasks/jobs.json", test::with(record, "\"101\"", "\"\""));
  slurm.write("queue", s.queued("101", 0, 3));
  CHECK(s.submit().runs == 0);
  CHECK(slurm.calls() == 2);
  CHECK(s.text("tasks/jobs.json") == record);
  // Without a job in the queue it was not submitted.
  folder.write("out/tasks/jobs.json", test::with(record, "\"101\"", "\"\""));
  slurm.write("queue", "");
  CHECK(s.submit().runs == 4);
}

TEST_CASE("a submission is written down before and after it", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  slurm.keep(s.out() / "tasks/jobs.json");
  s.submit();
  const auto before = nlohmann::json::parse(slurm.kept(1)),
             json = nlohmann::json::parse(s.text("tasks/jobs.json"));
  CHECK(before["jobs"][0]["job"] == "");
  CHECK(before["jobs"][0]["elements"] == "0-3");
  CHECK(json["jobs"][0]["job"] == "101");
  CHECK(json["jobs"][0]["elements"] == "0-3");
  slurm.refuse(3, "sbatch: error: killed");
  CHECK_THAT(s.refusal(), Catch::StartsWith("sbatch: killed; change --partition"));
  CHECK(nlohmann::json::parse(s.text("tasks/jobs.json")) == json);
}

TEST_CASE("refusals of Slurm name their cure, and what was submitted before is known", "[slurm]") {
  const FakeSlurm slurm;
  slurm.write("config", "MaxArraySize = 2\n");
  Submitted s(four_seeds);
  slurm.refuse(1, "sbatch: error: Batch job submission failed: Invalid partition name specified");
  CHECK(s.refusal() ==
        "sbatch: Invalid partition name specified; give one of sinfo --format=%P with --partition");
  slurm.refuse(
      2,
      "sbatch: error: QOSMaxSubmitJobPerUserLimit\nsbatch: error: Batch job submission failed: Job violates "
      "accounting/QOS policy (job submit limit, user's size and/or time limits)");
  CHECK(
      s.refusal() ==
      "sbatch: Job violates accounting/QOS policy (job submit limit, user's size and/or time limits) (2 of 4 tasks "
      "submitted, as job 101); repeat the command when some of your jobs have ended, or ask for less");
  slurm.write("queue", s.queued("101", 0, 1));
  slurm.remove("allowed");
  CHECK(s.submit().runs == 2);
  slurm.write("closed", "");
  CHECK(s.refusal() == "squeue: no answer; see that Slurm answers (sinfo), and repeat the command");
}

TEST_CASE("a job that failed without a trace shows that its nodes do not see the directory", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  s.submit();
  slurm.write("states", "JobId=102 ArrayJobId=101 JobState=FAILED Reason=NonZeroExitCode\n");
  CHECK_THAT(s.refusal(),
             Catch::Contains("out: job 101 has failed without writing there, as if its nodes did not see"));
  CHECK(slurm.calls() == 2);
  s.folder.folder().write("out/tasks/101_2.txt", "");
  CHECK(s.submit().runs == 4);
  // One that was cancelled before it began is submitted again.
  slurm.write("states", "JobId=102 JobState=CANCELLED Reason=None\n");
  CHECK(s.submit().runs == 4);
}

TEST_CASE("a thousand points are one array", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s("seeds = { first = 1, count = 1000 }\n");
  CHECK(s.submit().jobs.size() == 1);
  CHECK(slurm.has(1, "--array=0-999"));
}

TEST_CASE("a list tells the job of each run", "[slurm]") {
  const FakeSlurm slurm;
  Submitted s(four_seeds);
  s.submit();
  make_run(s.read(), 0, s.out() / "seed=1");
  slurm.write("queue", s.queued("101", 1, 1) + "101|2|RUNNING|None|scree tasks from 0\n");
  const Campaign c = s.read();
  const CampaignDirectory directory(s.out(), c, false);
  std::vector<Outcome> outcomes = directory.outcomes(c, test::host());
  auto notes = mark_queued(runs_in_queue(directory), c, directory, outcomes);
  CHECK(outcomes[0].status == Status::finished);
  CHECK(notes["seed=1"] == "job 101_0");
  CHECK(outcomes[1].status == Status::queued);
  CHECK(notes["seed=2"] == "job 101_1, Priority");
  CHECK(notes["seed=3"] == "job 101_2");
  CHECK(outcomes[3].status == Status::missing);
}
