#include "campaign_workspace.hpp"

#include <algorithm>

using namespace scree::test;

namespace {

const std::string four_runs =
    "seeds = [1, 2]\n[set]\ncontact.normal_stiffness = [1e4, 2e4]\n[prepare]\nscenario = 'prepare.toml'\n";
const std::string scene_of_state =
    with(with(with(discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n", ""),
              "radius = 0.01\n", ""),
         "random_velocity = 0.1\n", "");

struct TaskWorkspace : CampaignWorkspace {
  explicit TaskWorkspace(const std::string& rest = four_runs, const std::string& scene = scene_of_state)
      : CampaignWorkspace(rest, scene) {
    write("prepare.toml", discs);
  }
  std::string hash(const std::string& run) const { return record(run)["state_hash"]; }
  void check_same(const std::string& a, const std::string& b) const {
    for (const char* stiffness : {"10000", "20000"})
      for (const char* seed : {"1", "2"}) {
        const std::string run = std::string("/normal_stiffness=") + stiffness + ",seed=" + seed;
        CHECK(hash(a + run) == hash(b + run));
      }
  }
};

}  // namespace

TEST_CASE("tasks can be run in any order, and once more, and are then gathered", "[tools]") {
  const TaskWorkspace w;
  REQUIRE(w.scree("campaign campaign.toml --out whole --quiet").status == 0);
  const Outcome listed = w.scree(campaign_call + "--print-tasks --threads 1");
  INFO(listed.err);
  REQUIRE(listed.status == 0);
  CHECK(std::count(listed.out.begin(), listed.out.end(), '\n') == 6);
  CHECK(contains(listed.out, " campaign campaign.toml --out out --threads 1 --jobs 1 --quiet --task 0\n"));
  w.write("tasks.txt", listed.out);
  CHECK(w.scree(campaign_call + "--gather").status == 1);
  const Outcome elsewhere = w.scree("campaign campaign.toml --gather --out nowhere");
  CHECK(elsewhere.status == 2);
  CHECK(contains(elsewhere.err, "nowhere: holds no campaign; run or submit it first"));
  CHECK(!w.has("nowhere"));
  // From the last on: points make the preparations that they need, and several at a time take turns.
  const Outcome run = w.shell("tac tasks.txt | xargs -d '\\n' -P 4 -n 1 sh -c && tac tasks.txt | sh -e");
  INFO(run.out + run.err);
  CHECK(run.status == 0);
  w.check_same("whole", "out");
  const Outcome gathered = w.scree(campaign_call + "--gather");
  CHECK(gathered.status == 0);
  CHECK(contains(gathered.out, "\n4 finished\n"));
  CHECK(w.has("out/report.html"));
  CHECK(contains(w.scree(campaign_call + "--print-tasks --per-task 2").out, "--task 7\n"));
}

TEST_CASE("GNU parallel runs the tasks of a campaign", "[tools]") {
  const TaskWorkspace w;
  const Outcome run = w.shell(
      "command -v parallel > which.txt || exit 77\n"
      "scree campaign campaign.toml --out whole --quiet\nmkdir home; export HOME=$PWD/home\n"
      "scree campaign campaign.toml --out out --print-tasks | parallel --will-cite -j 2 && scree campaign "
      "campaign.toml --out out --gather");
  if (run.status == 77) return;
  INFO(run.err);
  CHECK(run.status == 0);
  w.check_same("whole", "out");
}

TEST_CASE("Snakemake runs the tasks of a campaign", "[tools]") {
  const TaskWorkspace w;
  w.write("Snakefile",
          "commands = open('tasks.txt').read().splitlines()\n"
          "rule all:\n"
          "    input: expand('done/{k}', k=range(len(commands)))\n"
          "rule task:\n"
          "    output: touch('done/{k}')\n"
          "    params: command=lambda wildcards: commands[int(wildcards.k)]\n"
          "    shell: '{params.command}'\n");
  const Outcome run = w.shell(
      "command -v snakemake > which.txt || exit 77\nexport HOME=$PWD\n"
      "scree campaign campaign.toml --out whole --quiet\n"
      "scree campaign campaign.toml --out out --print-tasks > tasks.txt && snakemake --cores 2 && scree campaign "
      "campaign.toml --out out --gather");
  if (run.status == 77) return;
  INFO(run.err);
  CHECK(run.status == 0);
  w.check_same("whole", "out");
}

TEST_CASE("a task that is stopped ends with 130, and goes on to the same bits", "[tools]") {
  const std::string lengthy =
      with(with(discs, "duration = 1e-4", "duration = 5"), "every = 2e-5", "every = 1e-2");
  const CampaignWorkspace w("seeds = [1]\n", lengthy);
  const Outcome stopped = w.shell(
      "scree campaign campaign.toml --out out --print-tasks > tasks.txt\n"
      "sh -c \"exec $(cat tasks.txt)\" &\nrun=$!\n"
      "until test -s out/seed=1/series/energy.csv; do sleep 0.05; done\nkill -TERM $run; wait $run");
  INFO(stopped.err);
  CHECK(stopped.status == 130);
  CHECK(w.record("out/seed=1")["status"] == "interrupted");
  CHECK(contains(w.scree(campaign_call + "--gather").out, "stopped  seed=1: its state is saved\n"));
  CHECK(w.shell("sh -e tasks.txt").status == 0);
  REQUIRE(w.scree("run scene.toml --out whole --set scene.seed=1").status == 0);
  CHECK(w.record("out/seed=1")["state_hash"] == w.record("whole")["state_hash"]);
}

TEST_CASE("a task that fails says why, and gathering has the status of a campaign", "[tools]") {
  const CampaignWorkspace w(
      "[set]\n\"time.step_guard\" = false\ntime.duration = 0.1\nparticles.random_velocity = [50, 0.1]\n");
  const Outcome run =
      w.shell("scree " + campaign_call + "--print-tasks > tasks.txt; head -n 1 tasks.txt | sh");
  CHECK(run.status == 3);
  CHECK(contains(run.out, "contact of particle "));
  CHECK(w.shell("tail -n 1 tasks.txt | sh").status == 0);
  const Outcome gathered = w.scree(campaign_call + "--gather");
  CHECK(gathered.status == 3);
  CHECK(contains(gathered.out, "\n1 finished, 1 failed\nFAILED   random_velocity=50: "));
  CHECK(w.record("out/random_velocity=50")["exit_status"] == 3);
}

TEST_CASE("the script of a task queues it again if its state is saved, and only then", "[tools]") {
  const CampaignWorkspace w("seeds = [1]\n");
  const auto requeued = [&](int status) {
    return w.shell(
        "rm -rf out; mkdir -p bin; cd bin\n"
        "printf '#!/bin/sh\\ncase $* in *config) ;; *) echo \"$*\" >> asked.txt ;; esac\\n' > scontrol\n"
        "printf '#!/bin/sh\\n' > squeue; printf '#!/bin/sh\\necho 7\\n' > sbatch\n"
        "printf '#!/bin/sh\\n' > sleep; printf '#!/bin/sh\\nexit " +
        std::to_string(status) +
        "\\n' > srun\nchmod +x *; cd ..; export PATH=$PWD/bin:$PATH; rm -f asked.txt\n"
        "scree campaign campaign.toml --out out --on slurm || exit 1\n"
        "SLURM_ARRAY_TASK_ID=0 SLURM_ARRAY_JOB_ID=7 SLURM_JOB_ID=7 sh out/tasks/task.sh 0; echo status $?; cat asked.txt");
  };
  CHECK(contains(requeued(130).out, "status 130\nrequeue 7_0\n"));
  for (const int status : {0, 1, 3}) CHECK_FALSE(contains(requeued(status).out, "requeue"));
  // A local campaign would do what the jobs do.
  const Outcome local = w.shell(
      "printf '#!/bin/sh\\necho \"7|0|PENDING|None|scree tasks from 0\"\\n' > bin/squeue\n"
      "export PATH=$PWD/bin:$PATH; scree " +
      campaign_call);
  CHECK(local.status == 2);
  CHECK(contains(local.err,
                 "out: a job of it is in the queue of Slurm; wait for them, add --on slurm, or cancel"));
}

TEST_CASE("options of batch systems that do not fit are refused", "[tools]") {
  const CampaignWorkspace w("seeds = [1]\n");
  check_refused(w, w.scree(campaign_call + "--time 10"), "scree campaign: --partition and --time ",
                "add --on slurm");
  check_refused(w, w.scree(campaign_call + "--gather --list"), "scree campaign: --list, --print-tasks, ",
                "one of them");
  check_refused(w, w.scree(campaign_call + "--per-task 2"), "scree campaign: --per-task ", "--print-tasks");
  check_refused(w, w.scree(campaign_call + "--task x"), "--task x: ", "give one of --print-tasks");
  check_refused(w, w.shell("PATH=/nowhere; scree " + campaign_call + "--on slurm"),
                "scontrol: is not there (", "leave --on slurm out");
}
