#pragma once

#include <string>

#include <scree/error.hpp>

namespace scree {

// An error of what is in a state: an array is missing, or is not what its owner takes. Its place is empty,
// since a state does not know its file.
class StateError : public Error {
 public:
  using Error::Error;
};

// Does work with the state of a file: errors of what is in it begin with the file.
template <class Work>
decltype(auto) with_state_of(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const StateError& error) {
    throw error.at(file);
  }
}

}  // namespace scree
