#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace scree {

// Process exit status of the command-line tools; an Error carries the status it causes.
enum class ExitStatus : int {
  success = 0,
  failure = 1,       // an [expect] was not met, or an unexpected failure
  bad_input = 2,     // invalid scenario, plug-in, path or option; nothing was written
  blow_up = 3,       // the simulation became unstable; output written so far is kept
  not_reached = 4,   // conditions of a stage were not met in time; output and the state are kept
  interrupted = 130  // Ctrl-C; output written so far is kept
};

// An error with a remedy. what() is one line, "place: problem; cure", without the parts that are empty.
class Error : public std::runtime_error {
 public:
  // place: "file:line:column", a path, a plug-in, a particle; problem: what is wrong; cure: what to do.
  Error(std::string place, std::string problem, std::string cure, ExitStatus status = ExitStatus::bad_input)
      : Error(std::make_shared<const Parts>(Parts{std::move(place), std::move(problem), std::move(cure)}),
              status) {}
  // From a complete line, all of which counts as the problem.
  explicit Error(const std::string& line, ExitStatus status = ExitStatus::bad_input)
      : Error("", line, "", status) {}

  ExitStatus status() const { return status_; }
  const std::string& place() const { return parts_->place; }
  const std::string& problem() const { return parts_->problem; }
  const std::string& cure() const { return parts_->cure; }

  // The same error at a place, which stands before its own place if it has one.
  Error at(const std::string& place, ExitStatus status) const {
    return {parts_->place.empty() ? place : place + ": " + parts_->place, problem(), cure(), status};
  }
  Error at(const std::string& place) const { return at(place, status_); }

 private:
  struct Parts {
    std::string place, problem, cure;

    std::string line() const {
      return (place.empty() ? "" : place + ": ") + problem + (cure.empty() ? "" : "; " + cure);
    }
  };

  Error(std::shared_ptr<const Parts> parts, ExitStatus status)
      : std::runtime_error(parts->line()), parts_(std::move(parts)), status_(status) {}

  std::shared_ptr<const Parts> parts_;  // shared, so that copies do not throw
  ExitStatus status_;
};

}  // namespace scree
