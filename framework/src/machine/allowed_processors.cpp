#include <algorithm>
#include <cmath>
#include <fstream>
#include <sched.h>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <scree/allowed_processors.hpp>

namespace scree {

namespace {

namespace fs = std::filesystem;

// Processors of the affinity; 0 if it cannot be asked for.
unsigned processors_of_affinity() {
  // The kernel refuses sets that are smaller than its own, whose size is not known beforehand.
  constexpr std::size_t most_sets = 64;  // of 1024 processors each
  for (std::size_t sets = 1; sets <= most_sets; sets *= 2) {
    std::vector<cpu_set_t> allowed(sets);
    const std::size_t bytes = sets * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, allowed.data()) == 0) return unsigned(CPU_COUNT_S(bytes, allowed.data()));
  }
  return 0;
}

// "max" is no number, and -1 of version 1 no quota.
unsigned quota(const std::string& allowed, const std::string& period) {
  std::istringstream a(allowed), p(period);
  double microseconds = 0, of = 0;
  if (!(a >> microseconds) || !(p >> of) || microseconds <= 0 || of <= 0) return 0;
  return unsigned(std::ceil(microseconds / of));
}

std::string word_in(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  stream >> word;
  return word;
}

unsigned quota_in(const fs::path& group) {
  std::ifstream both(group / "cpu.max");
  std::string allowed, period;
  if (both >> allowed >> period) return quota(allowed, period);
  return quota(word_in(group / "cpu.cfs_quota_us"), word_in(group / "cpu.cfs_period_us"));
}

unsigned smaller(unsigned a, unsigned b) { return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b); }

// The quota of a group and of those above it. In a container its path may be that on the host.
unsigned quota_below(const fs::path& hierarchy, fs::path group) {
  unsigned least = quota_in(hierarchy);
  for (; group.has_relative_path(); group = group.parent_path())
    least = smaller(least, quota_in(hierarchy / group.relative_path()));
  return least;
}

}  // namespace

unsigned processors_of_quota(std::string_view groups, const fs::path& root) {
  unsigned least = 0;
  std::istringstream lines{std::string(groups)};
  for (std::string line; std::getline(lines, line);) {  // "4:cpu,cpuacct:/path", of version 2 "0::/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      path = line.substr(second + 1);
    if (controllers.empty()) {
      least = smaller(least, quota_below(root, path));
      least = smaller(least, quota_below(root / "unified", path));
    } else if (("," + controllers + ",").find(",cpu,") != std::string::npos) {
      least = smaller(least, quota_below(root / controllers, path));
      least = smaller(least, quota_below(root / "cpu", path));
    }
  }
  return least;
}

unsigned allowed_processors() {
  std::ifstream file("/proc/self/cgroup");
  std::stringstream groups;
  groups << file.rdbuf();
  const unsigned allowed =
      smaller(processors_of_affinity(), processors_of_quota(groups.str(), "/sys/fs/cgroup"));
  return allowed ? allowed : std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace scree
