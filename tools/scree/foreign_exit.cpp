#include "foreign_exit.hpp"

#include <cstdlib>
#include <cstring>
#include <sys/syscall.h>
#include <unistd.h>

#include <scree/error.hpp>

namespace {

bool expected = false;
pid_t program = 0;

[[noreturn]] void leave(int status) {
  for (;;) syscall(SYS_exit_group, status);
}

// With write(): it may be called from anywhere.
[[noreturn]] void report_exit(const char* function) {
  for (const char* part :
       {"scree: a plug-in ended the program with ", function, "; let it report the problem instead\n"})
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
  leave(int(scree::ExitStatus::failure));
}

}  // namespace

// Exported by the program, so that plug-ins find them before those of the C library; what the C library
// itself calls stays its own. Status 0 would pass for success; with others a signal handler or a child
// process ends.
extern "C" {
__attribute__((noreturn, visibility("default"))) void _exit(int status) {
  if (status != 0 || getpid() != program) leave(status);
  report_exit("_exit()");
}
__attribute__((noreturn, visibility("default"))) void _Exit(int status) noexcept { _exit(status); }
}

namespace scree::tool {

void watch_for_exit() {
  program = getpid();
  for (const auto add : {std::atexit, std::at_quick_exit})
    add([] {
      if (!expected && getpid() == program) report_exit("exit()");
    });
}

void expect_exit() { expected = true; }

}  // namespace scree::tool
