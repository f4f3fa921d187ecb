#include "read_apart.hpp"

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

namespace scree::pictures {
namespace {

void limit(int resource, rlim_t most) {
  rlimit now = {};
  getrlimit(__rlimit_resource_t(resource), &now);
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(__rlimit_resource_t(resource), &now);
}

// Memory (bytes) that the process has already allocated.
[[maybe_unused]] rlim_t allocated() {
  std::ifstream file("/proc/self/statm");
  rlim_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> total >> resident >> shared >> text >> library >> data;
  return file ? data * rlim_t(sysconf(_SC_PAGESIZE)) : 0;
}

// Ten times what whole files need.
void limit_resources(std::uintmax_t file_size) {
  limit(RLIMIT_CPU, 4 + file_size / 1'000'000);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_DATA, allocated() + (rlim_t(2) << 30) + 200 * file_size);
#endif
}

}  // namespace

std::string read_apart(const std::filesystem::path& file, const Error& damaged,
                       const std::function<void(const Send&)>& read) {
  const ChildEnd end = in_child(
      [&](const Send& send) {
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(file, failed);
        limit_resources(failed ? 0 : size);
        try {
          read(send);
        } catch (const Error&) {
          throw;
        } catch (...) {  // VTK, of a damaged file
          _exit(1);
        }
      },
      {.silent = true});  // of readers that print what they miss
  if (end.how == ChildEnd::not_started)
    throw Error(fmt::format("{}: cannot be read ({}); end other processes", file.string(), end.text()),
                ExitStatus::failure);
  if (end.how == ChildEnd::threw) throw Error(end.exception);
  if (end.how != ChildEnd::returned) throw damaged;
  return end.sent;
}

}  // namespace scree::pictures
