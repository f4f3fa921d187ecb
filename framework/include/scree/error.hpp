#pragma once

#include <stdexcept>
#include <string>

namespace scree {

// Process exit status of the command-line tools; an Error carries the status it causes.
enum class ExitStatus : int {
  success = 0,
  failure = 1,       // an [expect] was not met, or an unexpected failure
  bad_input = 2,     // invalid scenario, plug-in, path or option; nothing was written
  blow_up = 3,       // the simulation became unstable; output written so far is kept
  interrupted = 130  // Ctrl-C; output written so far is kept
};

// An error with a remedy, in one line: location first ("file:line:column: ..."), remedy last.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& line, ExitStatus status = ExitStatus::bad_input)
      : std::runtime_error(line), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

}  // namespace scree
