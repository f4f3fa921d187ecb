#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/plugin/declaration.hpp>

namespace scree {

// How far a wall moves in a step so that its load at the end of the step is the pressing force. Loads grow as
// the wall moves towards the bodies.
struct LoadControl {
  double speed_limit = 0;  // v (m/s)
  double tries = 1000;     // n >= 1, rounded down

  // excess(s): load minus pressing force (N) after a displacement s (m) along the direction of the pressing
  // force. Returns an s of at most v|step|: of the multiples of v|step|/n the one whose load is nearest to
  // the pressing force, if on_grid; else where they are equal up to 1e-9 of `press` (N). If no s reaches the
  // pressing force, the one of v|step| or −v|step| that is nearest. guess: s (m) from which the search
  // begins; stiffness: the stiffness of the contacts (N/m), for the next search too, or 0.
  template <class Excess>
  double displacement(const Excess& excess, double guess, double step, double press, bool on_grid,
                      double& stiffness) const {
    const double limit = speed_limit * std::abs(step), spacing = on_grid ? limit / std::floor(tries) : 0;
    Interval interval = {{-limit}, {limit}};
    const double tolerance = on_grid ? 0 : 1e-9 * std::abs(press),
                 narrow = on_grid ? 1.5 * spacing : 1e-14 * limit;
    double s = rounded(std::clamp(guess, -limit, limit), spacing), last = s, last_excess = 0;
    for (int n = 0; n < most_evaluations; ++n) {
      const double e = excess(s);
      const double slope = s != last ? (e - last_excess) / (s - last) : stiffness;
      if (slope > 0) stiffness = slope;
      (e < 0 ? interval.lower : interval.upper) = {s, e, true};
      if (std::abs(e) <= tolerance || (e < 0 ? s >= limit : s <= -limit)) return s;
      if (interval.closed() && interval.width() <= narrow) break;
      // The secant does not lead on where the contacts are open, or where it approaches from one side.
      const bool trust = slope > 0 && n % 4 != 3;
      last = s, last_excess = e;
      s = interval.inside(trust ? s - e / slope : std::numeric_limits<double>::quiet_NaN(), e < 0, spacing);
    }
    return interval.nearest();
  }

 private:
  static constexpr int most_evaluations = 200;

  static double rounded(double s, double spacing) {
    return spacing > 0 ? spacing * std::round(s / spacing) : s;
  }

  // Ends between which the excess changes its sign; an end that was not tried is the limit.
  struct Interval {
    struct End {
      double at, excess = 0;
      bool tried = false;
    };
    End lower, upper;

    bool closed() const { return lower.tried && upper.tried; }
    double width() const { return upper.at - lower.at; }
    double nearest() const {
      if (!closed()) return lower.tried ? lower.at : upper.at;
      return -lower.excess <= upper.excess ? lower.at : upper.at;
    }
    // The proposal, on the grid, if it lies inside; else the limit ahead or, in a closed interval, its
    // middle.
    double inside(double proposal, bool ahead_is_upper, double spacing) const {
      if (!(proposal > lower.at && proposal < upper.at))
        proposal = closed() ? 0.5 * (lower.at + upper.at) : ahead_is_upper ? upper.at : lower.at;
      if (!closed() && (proposal == lower.at || proposal == upper.at)) return proposal;
      const double s = rounded(proposal, spacing);
      if (spacing > 0 && s <= lower.at)
        return lower.tried ? std::min(lower.at + spacing, upper.at) : lower.at;
      if (spacing > 0 && s >= upper.at)
        return upper.tried ? std::max(upper.at - spacing, lower.at) : upper.at;
      return s;
    }
  };
};

inline void declare_load_control(Declaration& d, LoadControl& limits) {
  d.number("speed_limit", limits.speed_limit, "m/s", positive,
           "v of walls with control \"servo\" or \"massless\"")
      .optional();
  d.number("tries", limits.tries, "", {.minimum = 1, .maximum = 1e9},
           "n; a servo wall tries the multiples of v Δt/n from −v Δt to v Δt; rounded down");
}

}  // namespace scree
