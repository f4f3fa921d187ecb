#pragma once

#include <csignal>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace scree {

// What became of work in a child process.
struct ChildEnd {
  enum How {
    returned,     // the work is done
    threw,        // an exception left it
    exited,       // the process ended before, with an exit status
    signalled,    // or by a signal
    out_of_time,  // it was ended, since it took too long
    not_started,  // there was no process to be had
  };
  How how = not_started;
  int number = 0;         // exit status, signal, or the value of errno for which it was not started
  std::string sent;       // what the work has sent up to its end
  std::string exception;  // its message
  double seconds = 0;     // the time limit

  // "signal 11, Segmentation fault", "status 3", "an exception (<message>)", "no end within 10 s".
  std::string text() const;
};

struct ChildOptions {
  double seconds = std::numeric_limits<double>::infinity();  // of wall time after which it is ended (s)
  bool silent = false;                                       // its standard output and error are dropped
};

// Runs work that may end or hold the process, such as code of others, in a child process, and waits for its
// end. The work sends what it finds. It has the default handlers of signals, leaves no core file, and ends
// with the thread that waits.
using Send = std::function<void(std::string_view bytes)>;
ChildEnd in_child(const std::function<void(const Send& send)>& work, const ChildOptions& options = {});

struct ProgramOptions {
  int output = -1;                  // descriptor of its standard output and error; -1: as in this process
  std::vector<int> inherited = {};  // further descriptors that stay open in the program
  // In its own process group and without standard input, so that Ctrl-C on the terminal does not reach it.
  bool own_group = false;
  int end_signal = SIGTERM;  // that it receives when the thread that started it ends
};

struct StartedProgram {
  pid_t process = -1;    // for the caller to wait for; -1 if the program was not started
  int no_process = 0;    // value of errno if there was no process to be had
  int not_executed = 0;  // value of errno if the program could not be executed
};

// Starts the program words[0], a path or a name in PATH, with the other words as arguments. It has the
// default handlers of signals.
StartedProgram start_program(const std::vector<std::string>& words, const ProgramOptions& options = {});

// Waits for the end of a process; its status, as of waitpid().
int wait_for(pid_t process);

}  // namespace scree
