#include "submitted_jobs.hpp"
#include "work_list.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/campaign/report.hpp>
#include <scree/campaign/submission.hpp>
#include <scree/counted.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;

// Slurm warns the steps of a job before its end, but not its script, so that the run is a step. Whether it is
// finished is in its record; 130 alone, "its state is saved", leads to another start, so that a task that was
// cancelled, whose script has ended by then, stays so. The last element has the job number of its array, by
// which Slurm would queue all elements again, finished ones too.
constexpr const char* script = R"(#!/bin/sh
# Written by scree campaign --on slurm. An element of an array of tasks; $1 is the task of element 0.
if [ ! -e {list} ]; then
  echo "scree: "{list}": is not there on $(hostname); give an --out that the nodes see" >&2
  exit 2
fi
srun --ntasks=1 --cpus-per-task="${{SLURM_CPUS_PER_TASK:-1}}" {command} --task $(($1 + SLURM_ARRAY_TASK_ID))
status=$?
if [ $status = 130 ]; then scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" && sleep 60; fi
exit $status
)";
constexpr const char* gather_script = R"(#!/bin/sh
# Written by scree campaign --on slurm. Gathers the tables when all tasks have ended.
exec {command} --gather
)";

std::string escaped_pattern(const std::string& path) {
  std::string escaped;
  for (const char c : path) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return escaped;
}

class Submitter {
 public:
  Submitter(const Campaign& campaign, CampaignDirectory& directory, const SubmissionOptions& submission,
            const ExecutionOptions& options, PluginHost& host)
      : campaign_(campaign),
        directory_(directory),
        submission_(submission),
        host_(host),
        folder_(fs::absolute(directory.files().path()) / CampaignDirectory::tasks_folder),
        largest_(slurm::largest_array()),
        jobs_(directory),
        queue_(slurm::queue(jobs_.name())),
        work_(campaign, directory, options, host, state_) {
    result_.name = jobs_.name();
    result_.finished = state_.finished_before;
    if (jobs_.adopt(queue_)) jobs_.write();
  }

  Submission submit() {
    leave_queued();
    work_.check();
    if (work_.waiting().empty()) return result_;
    jobs_.check_seen(queue_);
    for (const Job* job : work_.waiting()) wanted_.insert(&job->point);
    result_.runs = wanted_.size();
    write_report(campaign_, state_, directory_);
    const TaskNumbers numbers = list_tasks(
        campaign_, directory_, submission_.per_task,
        [&](const Point& point) { return wanted_.contains(&point); }, host_);
    write_scripts();
    try {
      submit_all(numbers);
    } catch (const Error& error) {
      throw partly(error, numbers);
    }
    return result_;
  }

 private:
  // Tasks of earlier calls that wait or run, with all their runs.
  void leave_queued() {
    const TaskList list(directory_);
    std::map<std::string, std::string> queued;  // with the inputs for which they were listed
    for (const auto& [task, job] : SubmittedJobs::queued_tasks(queue_)) {
      job_of_task_[task] = job.id();
      before_.push_back(job.job);
      if (task >= list.size()) continue;
      for (std::size_t k = 0; k < list[task].runs.size(); ++k)
        queued[list[task].runs[k]] = list[task].inputs[k];
      if (list[task].runs.size() == 1) job_of_run_[list[task].runs.front()] = job.id();
    }
    // A task of a run that has changed refuses itself.
    result_.before = std::erase_if(work_.waiting(), [&](Job* job) {
      const auto found = queued.find(job->point.name);
      return found != queued.end() && found->second == inputs_key(job->campaign, job->point, host_);
    });
  }

  void write_scripts() const {
    const std::string command = shell_line(submission_.command);
    const auto write = [&](const char* name, const std::string& text) {
      directory_.files().write_file(fmt::format("{}/{}", CampaignDirectory::tasks_folder, name), text);
    };
    write("task.sh", fmt::format(fmt::runtime(script), fmt::arg("command", command),
                                 fmt::arg("list", shell_line({(folder_ / "tasks.json").string()}))));
    write("gather.sh", fmt::format(fmt::runtime(gather_script), fmt::arg("command", command)));
  }

  std::vector<std::string> words(const std::string& comment, const char* output, unsigned processes,
                                 unsigned processors) const {
    std::vector<std::string> all = {
        "--job-name=" + jobs_.name(),
        "--comment=" + comment,
        "--requeue",
        "--open-mode=append",
        "--chdir=" + fs::current_path().string(),
        fmt::format("--output={}/{}", escaped_pattern(folder_.string()), output),
    };
    if (processes == 1) all.emplace_back("--nodes=1");
    all.push_back(fmt::format("--ntasks={}", processes));
    all.push_back(fmt::format("--cpus-per-task={}", processors));
    const SlurmTable& site = submission_.site;
    const auto add = [&](const char* option, const std::string& value) {
      if (!value.empty()) all.push_back(fmt::format("--{}={}", option, value));
    };
    add("partition", site.partition);
    add("time", site.time);
    add("mem", site.memory);
    add("account", site.account);
    add("qos", site.qos);
    add("constraint", site.constraint);
    all.insert(all.end(), site.options.begin(), site.options.end());
    return all;
  }

  // after: a job that must have ended well before.
  void submit_arrays(std::vector<std::size_t> tasks, const std::string& after) {
    std::sort(tasks.begin(), tasks.end());
    constexpr const char* warning = "--signal=TERM@60";  // (s) before the limit of time, up to a minute more
    for (const Array& array : arrays_of(tasks, largest_)) {
      std::vector<std::string> all = {warning};
      for (const std::string& word : words(SubmittedJobs::comment_of(array.first), "%A_%a.txt",
                                           submission_.processes, submission_.processors))
        all.push_back(word);
      all.push_back("--array=" + ranges_of(array.elements));
      if (!after.empty()) {
        all.push_back("--dependency=afterok:" + after);
        all.push_back("--kill-on-invalid-dep=yes");
      }
      all.push_back((folder_ / "task.sh").string());
      all.push_back(std::to_string(array.first));
      const std::string job = jobs_.submit(array, all);
      result_.jobs.push_back(job);
      result_.tasks += array.elements.size();
      for (const std::size_t element : array.elements)
        job_of_task_[array.first + element] = fmt::format("{}_{}", job, element);
    }
  }

  void submit_all(const TaskNumbers& numbers) {
    submit_arrays(numbers.preparations, "");
    std::vector<std::size_t> free;  // of points that wait for nothing
    std::size_t next = 0;           // of numbers.preparations
    for (std::size_t k = 0; k < numbers.points.size(); ++k) {
      const Point* preparation = campaign_.preparation ? &campaign_.preparation->points[k] : nullptr;
      std::string after;
      if (preparation && wanted_.contains(preparation))
        after = job_of_task_.at(numbers.preparations[next++]);
      else if (preparation)
        if (const auto queued = job_of_run_.find(preparation->name); queued != job_of_run_.end())
          after = queued->second;
      if (after.empty())
        free.insert(free.end(), numbers.points[k].begin(), numbers.points[k].end());
      else
        submit_arrays(numbers.points[k], after);
    }
    submit_arrays(free, "");
    submit_gather();
  }

  void submit_gather() {
    std::vector<std::string> all = words("scree gather", "gather.txt", 1, 1);
    std::vector<std::string> after = before_;
    after.insert(after.end(), result_.jobs.begin(), result_.jobs.end());
    std::sort(after.begin(), after.end());
    after.erase(std::unique(after.begin(), after.end()), after.end());
    all.push_back(fmt::format("--dependency=afterany:{}", fmt::join(after, ":")));
    all.push_back((folder_ / "gather.sh").string());
    result_.gather = slurm::submit(all);
  }

  Error partly(const Error& error, const TaskNumbers& numbers) const {
    std::size_t all = numbers.preparations.size();
    for (const auto& of : numbers.points) all += of.size();
    if (result_.tasks == 0) return error;
    return Error(
        error.place(),
        fmt::format("{} ({} of {} submitted, as {} {})", error.problem(), result_.tasks, counted(all, "task"),
                    result_.jobs.size() == 1 ? "job" : "jobs", fmt::join(result_.jobs, ", ")),
        error.cure());
  }

  const Campaign& campaign_;
  CampaignDirectory& directory_;
  const SubmissionOptions& submission_;
  PluginHost& host_;
  fs::path folder_;
  std::size_t largest_;
  SubmittedJobs jobs_;
  std::vector<QueuedJob> queue_;
  Execution state_;
  WorkList work_;
  Submission result_;
  std::set<const Point*> wanted_;
  std::vector<std::string> before_;                 // jobs of earlier calls, for the job that gathers
  std::map<std::size_t, std::string> job_of_task_;  // "12_3"
  std::map<std::string, std::string> job_of_run_;   // of those in the queue before
};

}  // namespace

Submission submit(const Campaign& campaign, CampaignDirectory& directory, const SubmissionOptions& submission,
                  const ExecutionOptions& options, PluginHost& host) {
  return Submitter(campaign, directory, submission, options, host).submit();
}

}  // namespace scree::campaign
