#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace scree::campaign {

// Processes that run side by side, each in a process group of its own, so that Ctrl-C on the terminal reaches
// them through signal() alone. They are told to end if this process dies. For one thread.
class ProcessPool {
 public:
  struct Ended {
    std::size_t id;
    std::string how;  // "exit status 3", "killed by signal 9 (Killed)"; empty for status 0
  };

  ProcessPool() = default;
  // Ends those that still run, and waits for them.
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  // Starts command[0], a path, with its output in the file log. The id is the caller's. Throws Error
  // (failure) where the log cannot be written or no process can be made.
  void start(std::size_t id, const std::vector<std::string>& command, const std::filesystem::path& log);
  // Those that have ended since the last call; waits for one, at most so many seconds, less if a signal
  // comes.
  std::vector<Ended> wait(double seconds);
  void signal(int number) const;

  std::size_t size() const { return running_.size(); }

 private:
  struct Running {
    std::size_t id;
    pid_t process;
    int alive;  // a pipe that closes with the process
  };
  std::vector<Running> running_;
};

}  // namespace scree::campaign
