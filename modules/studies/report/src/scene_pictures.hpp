#pragma once

#include "results.hpp"

namespace scree::report {

// The last picture of a run, and the first one if there is room for both; of a run without pictures a drawing
// of its bodies. Without a heading.
std::string scene_pictures(const Results& results);

}  // namespace scree::report
