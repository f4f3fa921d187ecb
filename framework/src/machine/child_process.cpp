#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/child_process.hpp>

namespace scree {

namespace {

// Each message in the pipe: its kind, its length and its bytes. The last says how the work ended, so that a
// child that ends with status 0 before does not pass for one that is done.
enum Kind : char { data = 'd', done = 'r', exception = 'e' };

void write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) _exit(1);  // the parent has ended
    bytes += written;
    count -= std::size_t(written);
  }
}

void send(int descriptor, Kind kind, std::string_view bytes) {
  const std::size_t size = bytes.size();
  char head[1 + sizeof(size)] = {char(kind)};
  std::memcpy(head + 1, &size, sizeof(size));
  write_all(descriptor, head, sizeof(head));
  write_all(descriptor, bytes.data(), size);
}

// In the child: it ends with the thread of its parent by a signal, and has the default handlers of others.
void begin_child(pid_t parent, int end_signal) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
    std::signal(number, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, end_signal);
  if (getppid() != parent) _exit(1);
}

void prepare_child(pid_t parent, bool silent) {
  begin_child(parent, SIGKILL);
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (!silent) return;
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void run_child(const std::function<void(const Send&)>& work, int output) {
  const auto fail = [&](const char* what) {
    std::fflush(nullptr);
    send(output, exception, what);
    _exit(1);
  };
  try {
    work([&](std::string_view bytes) { send(output, data, bytes); });
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail("of unknown type");
  }
  std::fflush(nullptr);
  send(output, done, "");
  _exit(0);
}

// Sorts what a child has written.
void read_messages(std::string_view bytes, ChildEnd& end) {
  std::size_t size = 0;
  constexpr std::size_t head = 1 + sizeof(size);
  while (bytes.size() >= head) {
    std::memcpy(&size, bytes.data() + 1, sizeof(size));
    if (size > bytes.size() - head) return;
    const std::string_view message = bytes.substr(head, size);
    if (bytes[0] == data) end.sent += message;
    if (bytes[0] == done) end.how = ChildEnd::returned;
    if (bytes[0] == exception) {
      end.how = ChildEnd::threw;
      end.exception = message;
    }
    bytes.remove_prefix(head + size);
  }
}

// A child that is waited for.
class Waiting {
 public:
  Waiting(pid_t child, int input, double seconds) : child_(child), input_(input), seconds_(seconds) {}

  ChildEnd end() {
    // A process that the child has started may hold the pipe after its end.
    while (!status_ && !late()) {
      pollfd polled = {input_, POLLIN, 0};
      const bool readable = poll(open_ ? &polled : nullptr, open_ ? 1 : 0, open_ ? 50 : 1) > 0;
      if (readable) open_ = read_some();
      if (!readable || !open_) look();
    }
    ChildEnd end;
    end.seconds = seconds_;
    if (!status_) {
      kill(child_, SIGKILL);
      while (!status_) look(0);
      end.how = ChildEnd::out_of_time;
      return end;
    }
    while (open_ && read_some()) {
    }
    end.how = WIFSIGNALED(*status_) ? ChildEnd::signalled : ChildEnd::exited;
    end.number = WIFSIGNALED(*status_) ? WTERMSIG(*status_) : WEXITSTATUS(*status_);
    read_messages(bytes_, end);
    return end;
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool late() const { return std::chrono::duration<double>(Clock::now() - began_).count() > seconds_; }

  // False at the end of what is there.
  bool read_some() {
    char block[1 << 16];
    const ssize_t count = read(input_, block, sizeof(block));
    if (count > 0) bytes_.append(block, std::size_t(count));
    return count > 0 || (count < 0 && errno == EINTR);
  }

  void look(int flags = WNOHANG) {
    int status = 0;
    if (waitpid(child_, &status, flags) == child_) status_ = status;
  }

  pid_t child_;
  int input_;
  double seconds_;
  Clock::time_point began_ = Clock::now();
  bool open_ = true;
  std::optional<int> status_;
  std::string bytes_;
};

// Blocks all signals during its lifetime: between fork and exec the child would handle a signal with the
// handlers of the parent, and then lose it.
class SignalBlock {
 public:
  SignalBlock() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalBlock() { restore(); }
  SignalBlock(const SignalBlock&) = delete;
  SignalBlock& operator=(const SignalBlock&) = delete;
  void restore() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

bool redirect(const ProgramOptions& options) {
  if (options.own_group) {
    const int nothing = open("/dev/null", O_RDONLY);
    if (setpgid(0, 0) != 0 || nothing < 0 || dup2(nothing, STDIN_FILENO) < 0) return false;
  }
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (options.output >= 0 && options.output != stream && dup2(options.output, stream) < 0) return false;
  return std::all_of(options.inherited.begin(), options.inherited.end(),
                     [](int descriptor) { return fcntl(descriptor, F_SETFD, 0) == 0; });
}

// In the child; nothing may be allocated between fork and exec. `failure` closes when the program is
// executed.
[[noreturn]] void execute(char* const* words, const ProgramOptions& options, int failure) {
  if (redirect(options)) execvp(words[0], words);
  const int code = errno;
  write_all(failure, reinterpret_cast<const char*>(&code), sizeof(code));
  _exit(127);
}

// The value of errno with which a program could not be executed; 0 if it is.
int failure_of(int pipe) {
  int code = 0;
  ssize_t count = 0;
  do count = read(pipe, &code, sizeof(code));
  while (count < 0 && errno == EINTR);
  return count == ssize_t(sizeof(code)) ? code : 0;
}

}  // namespace

std::string ChildEnd::text() const {
  switch (how) {
    case returned:
      return "it returned";
    case threw:
      return fmt::format("an exception ({})", exception);
    case exited:
      return fmt::format("status {}", number);
    case signalled:
      return fmt::format("signal {}, {}", number, strsignal(number));
    case out_of_time:
      return fmt::format("no end within {:g} s", seconds);
    case not_started:
      return fmt::format("no process can be started, {}", std::strerror(number));
  }
  return "";
}

ChildEnd in_child(const std::function<void(const Send&)>& work, const ChildOptions& options) {
  ChildEnd none;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    none.number = errno;
    return none;
  }
  std::fflush(nullptr);  // or the child would write what is buffered a second time
  const pid_t parent = getpid(), child = fork();
  none.number = errno;
  if (child == 0) {
    close(ends[0]);
    prepare_child(parent, options.silent);
    run_child(work, ends[1]);
  }
  close(ends[1]);
  if (child > 0) fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const ChildEnd end = child > 0 ? Waiting(child, ends[0], options.seconds).end() : none;
  close(ends[0]);
  return end;
}

StartedProgram start_program(const std::vector<std::string>& words, const ProgramOptions& options) {
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  StartedProgram started;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {-1, errno, 0};
  const SignalBlock signals;
  const pid_t parent = getpid(), child = fork();
  if (child < 0) started.no_process = errno;
  if (child == 0) {
    begin_child(parent, options.end_signal);
    signals.restore();
    execute(pointers.data(), options, ends[1]);
  }
  close(ends[1]);
  if (child > 0) started.not_executed = failure_of(ends[0]);
  close(ends[0]);
  if (child > 0 && started.not_executed) wait_for(child);
  if (child > 0 && !started.not_executed) started.process = child;
  return started;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace scree
