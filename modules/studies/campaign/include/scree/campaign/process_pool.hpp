#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace scree::campaign {

// Concurrent child processes, each in its own process group, so that Ctrl-C on the terminal reaches them only
// through signal(). They receive SIGTERM if this process dies. Not thread-safe.
class ProcessPool {
 public:
  struct Ended {
    std::size_t id;
    std::string how;            // "exit status 3", "killed by signal 9 (Killed)"; empty for status 0
    std::optional<int> status;  // absent if killed
  };
  // What is done with an existing log.
  enum class Log { replace, append };

  ProcessPool() = default;
  // Terminates the running processes and waits for them.
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  // Starts the program at the path command[0], with its output in the file `log`; `id` identifies it in
  // Ended. A program that cannot be executed ends with status 127, with the reason in its log. Throws Error
  // (failure) if the log cannot be written or no process can be started.
  void start(std::size_t id, const std::vector<std::string>& command, const std::filesystem::path& log,
             Log existing = Log::replace);
  // Processes that have ended since the last call. Waits for at least one, at most `seconds` or until a
  // signal.
  std::vector<Ended> wait(double seconds);
  void signal(int number) const;

  std::size_t size() const { return running_.size() + not_executed_.size(); }

 private:
  struct Running {
    std::size_t id;
    pid_t process;
    int alive;  // read end of a pipe that closes when the process ends
  };
  std::vector<Running> running_;
  std::vector<Ended> not_executed_;
};

}  // namespace scree::campaign
