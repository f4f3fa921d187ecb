#pragma once

#include <array>
#include <chrono>

namespace scree {

// Wall time per phase of a step (s), for benchmarks; in threaded phases only the calling thread is timed.
// Reading the clock makes contact evaluation about 10 % slower.
class Profile {
 public:
  enum Phase {
    boundaries,
    integrate,  // first and second half of the motion of bodies
    neighbours,
    gather,
    geometry,
    law,
    reduce,
    body_forces,
    audit,
    phase_count
  };
  static constexpr std::array<const char*, phase_count> names = {
      "boundaries", "integrate", "neighbours", "gather", "geometry", "law", "reduce", "body_forces", "audit"};

  void add(Phase phase, double seconds) { seconds_[phase] += seconds; }
  double seconds(Phase phase) const { return seconds_[phase]; }

 private:
  std::array<double, phase_count> seconds_ = {};
};

// Stopwatch: lap() adds the time since the previous lap to a phase. Without a profile it costs one branch.
class Laps {
 public:
  explicit Laps(Profile* profile) : profile_(profile) {
    if (profile_) last_ = Clock::now();
  }
  void lap(Profile::Phase phase) {
    if (!profile_) return;
    const Clock::time_point now = Clock::now();
    profile_->add(phase, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Profile* profile_;
  Clock::time_point last_;
};

}  // namespace scree
