#pragma once

#include <filesystem>
#include <string_view>

namespace scree {

// Processors that this process may use, at least 1: those of its affinity (taskset, a job of a cluster), or
// fewer where a control group limits its processor time (containers, batch systems). Not those of the
// computer.
unsigned allowed_processors();

// The processors that the quotas of control groups allow, rounded up; 0 without a quota. groups: the text of
// /proc/self/cgroup. root: the folder with the hierarchies, /sys/fs/cgroup, of version 1, 2 or both.
unsigned processors_of_quota(std::string_view groups, const std::filesystem::path& root);

}  // namespace scree
