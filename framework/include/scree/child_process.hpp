#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>

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

// Runs work that may end or hold the process, such as code of others, in a child process, and waits for its end. The
// work sends what it finds. Its handlers of signals are those of the system, it leaves no core file, and it ends with
// the thread that waits.
using Send = std::function<void(std::string_view bytes)>;
ChildEnd in_child(const std::function<void(const Send& send)>& work, const ChildOptions& options = {});

}  // namespace scree
