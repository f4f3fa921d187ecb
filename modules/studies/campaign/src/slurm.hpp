#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace scree::campaign {

// An element of an array, or a job, that waits or runs.
struct QueuedJob {
  std::string job;                     // number of the whole array
  std::optional<std::size_t> element;  // of the array
  std::string state, reason, comment;  // "PENDING", "Priority", the text of sbatch --comment

  std::string id() const { return element ? job + "_" + std::to_string(*element) : job; }
};

// The commands of Slurm, found in PATH. Every call throws Error (bad_input), with a cure, if its command is
// missing or Slurm does not answer.
namespace slurm {

// MaxArraySize: numbers of elements are below it.
std::size_t largest_array();
// All jobs of this name of all users.
std::vector<QueuedJob> queue(const std::string& name);
// Calls sbatch with these words. Returns the number of the job. Throws Error with the reason of Slurm.
std::string submit(const std::vector<std::string>& words);
// States of a job and its elements, also some minutes after their ends; empty after that.
std::vector<std::string> states(const std::string& job);

}  // namespace slurm

// Part of a list of tasks in one array.
struct Array {
  std::size_t first = 0;              // task of element 0
  std::vector<std::size_t> elements;  // ascending
};
// Tasks, ascending, cut into arrays whose elements are below `largest`.
std::vector<Array> arrays_of(const std::vector<std::size_t>& tasks, std::size_t largest);
// "0-3,7" of sbatch --array, and back.
std::string ranges_of(const std::vector<std::size_t>& elements);
std::vector<std::size_t> elements_of(const std::string& ranges);

}  // namespace scree::campaign
