#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// Runs that a batch system starts together: preparations, or points that begin from one preparation.
struct Task {
  std::vector<std::string> runs;    // names of points
  std::vector<std::string> inputs;  // inputs_key() of each when the task was listed
};

// tasks/tasks.json in the directory of a campaign. Tasks are only added, so that the number of a task means
// the same as long as it waits in a queue, whatever the campaign file says by then.
class TaskList {
 public:
  // Of a directory; empty if it has none. Throws Error if it cannot be read.
  explicit TaskList(const CampaignDirectory& directory);

  // Number of a task of these points, counted from 0; a new one if none has the same runs and inputs.
  std::size_t number_of(const Campaign& campaign, const std::vector<const Point*>& points,
                        const PluginHost& host);
  void write(const CampaignDirectory& directory) const;

  std::size_t size() const { return tasks_.size(); }
  const Task& operator[](std::size_t number) const { return tasks_[number]; }

 private:
  std::size_t add(Task task);

  std::vector<Task> tasks_;
  std::map<std::pair<std::vector<std::string>, std::vector<std::string>>, std::size_t> numbers_;
};

// Points in tasks of `per_task`, each in an order in which preparations come before their points.
struct TaskNumbers {
  std::vector<std::size_t> preparations;         // a task each
  std::vector<std::vector<std::size_t>> points;  // the tasks of each preparation, or all
};
// Lists the tasks of all points and preparations that are `wanted`, by name, and writes the list.
TaskNumbers list_tasks(const Campaign& campaign, const CampaignDirectory& directory, std::size_t per_task,
                       const std::function<bool(const Point&)>& wanted, const PluginHost& host);

struct TaskOptions {
  double patience = 180;  // (s) for a run that another process still writes, as after a lost node
  unsigned restarts = 0;  // of the task by the batch system so far
};

// Does a task, without tables: its runs that have finished are kept, interrupted ones go on, and a
// preparation that is missing is made first, or waited for while another task makes it. Throws Error if there
// is no such task, if the campaign is no longer that of the list, if another process writes a run for longer
// than the patience, and if a run was stopped before its first further step after the third restart.
Execution run_task(const Campaign& campaign, CampaignDirectory& directory, std::size_t number,
                   const ExecutionOptions& options, const TaskOptions& task, PluginHost& host);

// Words as a line for a shell.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace scree::campaign
