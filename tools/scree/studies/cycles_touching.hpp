#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace scree::tool {

// The touch of a rattler that is the latest before a minimum of the load.
struct LatestTouch {
  long long body = 0;  // id
  double before = 0;   // (s) before the minimum; 0: it touches then
};

// Bodies that seldom touch others, from a series of the probe `touching`.
struct Rattlers {
  struct Body {
    long long id = 0;
    double share = 0;  // [0, seldom) of the observations in which it touched
  };
  static constexpr double seldom = 0.5;

  std::vector<Body> bodies;          // of the minima that count, by id
  std::vector<LatestTouch> touches;  // at each minimum; empty without bodies
};

// minima: (s) of the load; drop: those that do not count. The series has a row at each. Throws Error with file and cure.
Rattlers read_rattlers(const std::filesystem::path& file, const std::vector<double>& minima,
                       std::size_t drop);

}  // namespace scree::tool
