#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace scree {

// Keeps the handlers of two signals while METIS works, which takes them over and sets them back without their
// flags, so that the second signal would end the program.
class KeptHandlers {
 public:
  KeptHandlers() {
    for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], nullptr, &before_[k]);
  }
  KeptHandlers(const KeptHandlers&) = delete;
  KeptHandlers& operator=(const KeptHandlers&) = delete;
  ~KeptHandlers() {
    for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &before_[k], nullptr);
  }

 private:
  static constexpr std::array<int, 2> signals = {SIGABRT, SIGTERM};
  std::array<struct sigaction, 2> before_ = {};
};

}  // namespace scree
