#pragma once

#include <stdexcept>
#include <string>

namespace scree {

// Process exit status of the command-line tools; an Error carries the one it leads to.
enum class ExitStatus : int {
  success = 0,
  failure = 1,       // an [expect] was not met, or an unforeseen failure
  bad_input = 2,     // scenario, plug-in, path or option is at fault; nothing was written
  blow_up = 3,       // the run itself went wrong; what was written stays
  interrupted = 130  // Ctrl-C; what was written stays
};

// What went wrong and what to do about it: one line, place first ("file:line:column: ..."), cure last.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& line, ExitStatus status = ExitStatus::bad_input)
      : std::runtime_error(line), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

}  // namespace scree
