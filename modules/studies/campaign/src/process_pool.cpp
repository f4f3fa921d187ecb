#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/campaign/process_pool.hpp>
#include <scree/error.hpp>
#include <scree/files/descriptor.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

namespace {

using files::Descriptor;

Error no_process(int code) {
  return Error(fmt::format("no process can be started ({}); use fewer --jobs", std::strerror(code)),
               ExitStatus::failure);
}

// Blocks all signals during its lifetime: between fork and exec a signal would be handled by the handlers of
// the parent in the child, and then be lost.
class SignalBlock {
 public:
  SignalBlock() {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalBlock() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalBlock(const SignalBlock&) = delete;
  SignalBlock& operator=(const SignalBlock&) = delete;
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_;
};

// Body of the child process. No allocation is allowed between fork and exec.
[[noreturn]] void run_child(char* const* words, pid_t parent, int log, int alive, const sigset_t& signals) {
  setpgid(0, 0);
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  const int null_device = open("/dev/null", O_RDONLY);
  const bool ready = getppid() == parent && null_device >= 0 && dup2(null_device, STDIN_FILENO) >= 0 &&
                     dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0 &&
                     fcntl(alive, F_SETFD, 0) == 0;
  if (ready) execv(words[0], words);
  constexpr std::string_view no_program = "scree: the program cannot be started; install it again\n",
                             too_long =
                                 "scree: a value is too long for a command line (128 KiB); put it into the "
                                 "scenario instead of [set]\n";
  const std::string_view line = errno == E2BIG ? too_long : no_program;
  if (write(log, line.data(), line.size()) < 0) _exit(126);
  _exit(127);
}

std::string exit_description(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
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
  std::vector<std::string> copies = command;
  std::vector<char*> words;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  const SignalBlock signals;
  const pid_t parent = getpid(), process = fork();
  if (process == 0) run_child(words.data(), parent, output.get(), held.get(), signals.before());
  if (process < 0) throw no_process(errno);
  running_.push_back({id, process, alive.release()});
}

std::vector<ProcessPool::Ended> ProcessPool::wait(double seconds) {
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
