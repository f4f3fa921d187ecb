#pragma once

#include <map>
#include <string>
#include <vector>

#include <scree/parameters.hpp>

namespace scree {

// The time that a plug-in sees. It starts again when a stage sets parameters, but goes on for functions of
// time that the stage does not set.
class Clock {
 public:
  // The time that the plug-in sees at a time of the simulation (s).
  double at(double time) const { return time - start_; }
  // Starts again at a time (s), except for the functions of these keys.
  void restart(double time, const std::vector<std::string>& going_on);
  // Parameters whose functions of time are ahead of the clock by as much as they have to be.
  Parameters shown(Parameters parameters) const;
  bool shows_others() const { return !ahead_.empty(); }

  void transfer(const class StateTransfer& state);

 private:
  double start_ = 0;                     // (s)
  std::map<std::string, double> ahead_;  // (s) by key
};

}  // namespace scree
