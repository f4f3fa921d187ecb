#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>

#include <scree/available_memory.hpp>

namespace scree {

double available_memory() {
  const double there = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  rlimit limit = {};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(there, double(limit.rlim_cur)) : there;
}

}  // namespace scree
