#pragma once

#include <filesystem>
#include <string_view>

namespace scree {

// Number of processors that this process may use, at least 1: its affinity (taskset, a job of a cluster) and
// the processor time that control groups grant it (containers, batch systems) limit it. The computer may have
// more.
unsigned allowed_processors();

// The processors that the quotas of control groups allow, rounded up; 0 without a quota. groups: the text of
// /proc/self/cgroup. root: the folder with the hierarchies, /sys/fs/cgroup, of version 1, 2 or both.
unsigned processors_of_quota(std::string_view groups, const std::filesystem::path& root);

}  // namespace scree
