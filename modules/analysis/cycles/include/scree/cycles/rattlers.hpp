#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace scree::cycles {

// The last touch of any rattler before a minimum of the load.
struct LatestTouch {
  long long body = 0;  // id
  double before = 0;   // (s) before the minimum; 0: it touches then
};

// A body that seldom touches others.
struct Rattler {
  static constexpr double seldom = 0.5;
  long long id = 0;
  double share = 0;  // of the observations in which it touched; from 0 to below `seldom`
};

struct Rattlers {
  std::vector<Rattler> bodies;       // from the minima that count, by id
  std::vector<LatestTouch> touches;  // at each minimum; empty without bodies
};

// Reads a series of the probe `touching` with a row at each minimum (s) of the load. drop: number of minima
// that do not count. Throws Error with file and cure.
Rattlers read_rattlers(const std::filesystem::path& file, const std::vector<double>& minima,
                       std::size_t drop);

}  // namespace scree::cycles
