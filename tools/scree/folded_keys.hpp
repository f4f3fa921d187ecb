#pragma once

#include <string>
#include <vector>

namespace scree::tool {

// A key that stands for several which differ in a part of their names: "stress_{x,y,z}_{low,high}" is every
// combination. The keys by themselves, joined by commas, if they are not all combinations of their parts
// between underscores.
std::string folded(const std::vector<std::string>& keys);

}  // namespace scree::tool
