#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include <scree/campaign/process_pool.hpp>
#include <scree/child_process.hpp>
#include <scree/error.hpp>
#include <scree/files/descriptor.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

namespace {

using files::Descriptor;

Error no_process(int code) {
  return Error("", fmt::format("no process can be started ({})", std::strerror(code)), "use fewer --jobs",
               ExitStatus::failure);
}

const char* line_of_failure(int code) {
  return code == E2BIG ? "scree: a value is too long for a command line (128 KiB); put it into the scenario "
                         "instead of [set]\n"
                       : "scree: the program cannot be started; install it again\n";
}

std::string exit_description(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace

ProcessPool::~ProcessPool() {
  signal(SIGTERM);
  for (const Running& one : running_) {
    wait_for(one.process);
    close(one.alive);
  }
}

void ProcessPool::start(std::size_t id, const std::vector<std::string>& command,
                        const std::filesystem::path& log, Log existing) {
  std::error_code failed;
  const bool append = existing == Log::append &&
                      std::filesystem::is_regular_file(std::filesystem::symlink_status(log, failed));
  const Descriptor output = append ? files::append_file(log.c_str()) : files::create_file(log.c_str());
  if (!output.is_open()) run::throw_unwritable(log);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw no_process(errno);
  Descriptor alive(ends[0]);
  const Descriptor held(ends[1]);
  const StartedProgram started =
      start_program(command, {.output = output.get(), .inherited = {held.get()}, .own_group = true});
  if (started.no_process) throw no_process(started.no_process);
  if (started.not_executed) {
    constexpr int status = 127;  // as a shell has it
    files::write_all(output, line_of_failure(started.not_executed));
    not_executed_.push_back({id, fmt::format("exit status {}", status), status});
    return;
  }
  running_.push_back({id, started.process, alive.release()});
}

std::vector<ProcessPool::Ended> ProcessPool::wait(double seconds) {
  if (!not_executed_.empty()) return std::exchange(not_executed_, {});
  std::vector<pollfd> polled;
  for (const Running& one : running_) polled.push_back({one.alive, POLLIN, 0});
  if (poll(polled.data(), polled.size(), int(1000 * seconds)) <= 0) return {};
  std::vector<Ended> ended;
  std::vector<Running> still;
  for (std::size_t k = 0; k < running_.size(); ++k) {
    if (polled[k].revents == 0) {
      still.push_back(running_[k]);
      continue;
    }
    const int status = wait_for(running_[k].process);
    ended.push_back({running_[k].id, exit_description(status), std::nullopt});
    if (WIFEXITED(status)) ended.back().status = WEXITSTATUS(status);
    close(running_[k].alive);
  }
  running_ = std::move(still);
  return ended;
}

void ProcessPool::signal(int number) const {
  for (const Running& one : running_) kill(one.process, number);
}

}  // namespace scree::campaign
