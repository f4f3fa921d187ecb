#pragma once

#include <chrono>
#include <utility>

namespace scree::run {

// Wall time since its start, and how much of it was spent on output.
class Stopwatch {
 public:
  double total() const { return seconds(start_, Clock::now()); }  // (s)
  double output() const { return output_; }                       // (s)

  // Calls work(), whose duration counts as output, and returns its result.
  template <class Work>
  auto time_output(const Work& work) {
    const Counted counted{*this, Clock::now()};
    return work();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }
  struct Counted {
    Stopwatch& watch;
    Clock::time_point start;
    ~Counted() { watch.output_ += seconds(start, Clock::now()); }
  };

  Clock::time_point start_ = Clock::now();
  double output_ = 0;
};

}  // namespace scree::run
