#pragma once

#include <string>
#include <utility>

#include <scree/error.hpp>

namespace scree::files {

// An error of the directory or file of results. Its cure ends with "give another --out", after a cure for the
// place itself if there is one. Where results cannot go elsewhere, as in a run that goes on, in_place() is
// reported instead.
class PlaceError : public Error {
 public:
  // cure: for the place itself; empty if there is none but to leave it, where in_place() has the cure `last`.
  PlaceError(const std::string& place, const std::string& problem, const std::string& cure,
             ExitStatus status = ExitStatus::bad_input, const std::string& last = "check its permissions")
      : Error(place, problem, (cure.empty() ? "" : cure + ", or ") + "give another --out", status),
        cure_in_place_(cure.empty() ? last : cure) {}

  // The error for results that stay where they are.
  Error in_place() const { return {place(), problem(), cure_in_place_, status()}; }
  // The same error with another status.
  PlaceError with_status(ExitStatus status) const { return {*this, status}; }

 private:
  PlaceError(const PlaceError& other, ExitStatus status)
      : Error(other.place(), other.problem(), other.cure(), status), cure_in_place_(other.cure_in_place_) {}

  std::string cure_in_place_;
};

// Does work whose results stay where they are: its PlaceErrors leave as Error with the cure for the place
// itself.
template <class Work>
auto in_place(const Work& work) {
  try {
    return work();
  } catch (const PlaceError& error) {
    throw error.in_place();
  }
}

// The line of an error for the record of results. went_on: they stay where they are.
inline std::string record_line(const Error& error, bool went_on) {
  const auto* place = dynamic_cast<const PlaceError*>(&error);
  return place && went_on ? place->in_place().what() : error.what();
}

// Throws the error that is being caught again, with the status failure instead of bad_input, which is
// reserved for errors before anything is written.
[[noreturn]] inline void rethrow_as_failure(const Error& error) {
  if (error.status() != ExitStatus::bad_input) throw;
  if (const auto* place = dynamic_cast<const PlaceError*>(&error))
    throw place->with_status(ExitStatus::failure);
  throw Error(error.place(), error.problem(), error.cure(), ExitStatus::failure);
}

}  // namespace scree::files
