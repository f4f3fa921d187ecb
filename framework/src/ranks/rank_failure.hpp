#pragma once

#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <scree/ranks.hpp>

namespace scree {

// A failure that all ranks know of.
struct SharedFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What has failed on one rank, kept until all ranks know, so that none waits for messages that do not come.
class RankFailure {
 public:
  // Calls a function; keeps what it throws unless something is kept already.
  template <class Function>
  void guard(const Function& function) {
    try {
      function();
    } catch (...) {
      keep(std::current_exception());
    }
  }
  bool any() const { return error_ != nullptr; }

  // Called by all ranks once one of them has failed: throws the failure of the lowest such rank, on the first
  // rank as Error or as an exception with the same text, on others as SharedFailure.
  [[noreturn]] void throw_on_all(Ranks& ranks);

 private:
  void keep(std::exception_ptr error);

  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();  // several threads may fail
  std::exception_ptr error_;
};

}  // namespace scree
