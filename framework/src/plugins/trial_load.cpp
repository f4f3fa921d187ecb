#include "plugins/trial_load.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/plugin/abi.h>

namespace scree {

namespace {

constexpr int survived = 42;

[[noreturn]] void load_and_leave(const char* library) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  if (void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL))
    if (const auto query = reinterpret_cast<scree_query_function>(dlsym(handle, SCREE_QUERY_SYMBOL))) query();
  _exit(survived);
}

}  // namespace

std::optional<std::string> fatal_load(const std::filesystem::path& library) {
  std::fflush(nullptr);  // or exit() in the child would write what is buffered a second time
  const pid_t child = fork();
  if (child == 0) load_and_leave(library.c_str());
  int ended = 0;
  while (child > 0 && waitpid(child, &ended, 0) < 0)
    if (errno != EINTR) return {};
  if (child < 0 || (WIFEXITED(ended) && WEXITSTATUS(ended) == survived)) return {};
  if (WIFSIGNALED(ended)) return fmt::format("signal {}, {}", WTERMSIG(ended), strsignal(WTERMSIG(ended)));
  return fmt::format("status {}", WEXITSTATUS(ended));
}

}  // namespace scree
