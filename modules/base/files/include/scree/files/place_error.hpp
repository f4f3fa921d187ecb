#pragma once

#include <string>
#include <utility>

#include <scree/error.hpp>

namespace scree::files {

// An error of the place of results. Its line ends with "give another --out", behind a cure for the place itself if there is one; who
// cannot take another place, such as a run that goes on, reports in_place() instead.
class PlaceError : public Error {
 public:
  // problem: location first. cure: for the place itself; empty if there is none but to leave it, where in_place() says `last`.
  explicit PlaceError(std::string problem, const std::string& cure = "",
                      ExitStatus status = ExitStatus::bad_input,
                      const std::string& last = "check its permissions")
      : Error(problem + "; " + (cure.empty() ? "" : cure + ", or ") + "give another --out", status),
        in_place_(std::move(problem) + "; " + (cure.empty() ? last : cure)) {}

  // The line for results that stay where they are.
  const std::string& in_place() const { return in_place_; }
  // The same where a status is reserved for others.
  PlaceError with_status(ExitStatus status) const { return {*this, status}; }

 private:
  PlaceError(const PlaceError& other, ExitStatus status)
      : Error(other.what(), status), in_place_(other.in_place_) {}

  std::string in_place_;
};

// Does some work in a place that stays the same. Throws its errors as Error with the cure for the place itself.
template <class Work>
auto in_place(const Work& work) {
  try {
    return work();
  } catch (const PlaceError& error) {
    throw Error(error.in_place(), error.status());
  }
}

// The line of an error for the record of results; of those that went on in their place, with the cure for the place itself.
inline std::string record_line(const Error& error, bool went_on) {
  const auto* place = dynamic_cast<const PlaceError*>(&error);
  return place && went_on ? place->in_place() : error.what();
}

// Throws the error that is being caught again, with the status failure for bad_input, which is reserved for errors before
// anything is written.
[[noreturn]] inline void rethrow_as_failure(const Error& error) {
  if (error.status() != ExitStatus::bad_input) throw;
  if (const auto* place = dynamic_cast<const PlaceError*>(&error))
    throw place->with_status(ExitStatus::failure);
  throw Error(error.what(), ExitStatus::failure);
}

}  // namespace scree::files
