#pragma once

#include <string>
#include <vector>

namespace scree::pictures {

// A vector at each particle of a frame, from its centre.
struct ArrowField {
  std::vector<double> vectors;  // (3N) in any unit
  double longest = 0;           // (m) length at which the longest is drawn
  std::string title;            // of the colour bar, which shows lengths over the longest
  std::string note;             // what the arrows are
};

}  // namespace scree::pictures
