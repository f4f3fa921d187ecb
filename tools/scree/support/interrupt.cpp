#include "support/verbs.hpp"

#include <csignal>
#include <ctime>
#include <unistd.h>

namespace scree::tool {

namespace {

// SIGUSR1 is the only one that mpirun passes on without killing the ranks soon after.
constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};

std::atomic<bool> interrupted = false;
std::atomic<std::int64_t> first_signal = 0;  // (ms) of the monotonic clock
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "signal handlers cannot wait for locks");

std::int64_t milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1000 + now.tv_nsec / 1000000;
}

void on_interrupt(int signal) {
  // coreutils timeout, for one, signals the process and then its group.
  constexpr std::int64_t same_request = 1000;  // (ms)
  if (!interrupted) {
    first_signal = milliseconds();
    interrupted = true;
  } else if (signal != SIGHUP && signal != SIGUSR1 && milliseconds() - first_signal > same_request) {
    _exit(int(ExitStatus::interrupted));
  }
}

}  // namespace

const std::atomic<bool>& watch_for_interrupt() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  for (const int signal : ending_signals) sigaddset(&action.sa_mask, signal);
  // What was started with a signal ignored is to outlive it: by nohup a closed terminal, in the background of
  // a script Ctrl-C.
  for (const int signal : ending_signals) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
  return interrupted;
}

}  // namespace scree::tool
