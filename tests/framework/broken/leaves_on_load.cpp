// A library whose constructor ends the process that loads it by the system call itself, with the status of
// success.
#include <sys/syscall.h>
#include <unistd.h>

namespace {

struct Leave {
  Leave() { syscall(SYS_exit_group, 0); }
} now;

}  // namespace
