#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scree::document {

// One step of a dotted path: stage[1] has the name "stage" and one index.
struct OverrideSegment {
  std::string name;
  std::vector<std::size_t> indices;  // from 0
};

// "key=value" taken apart.
struct OverridePath {
  std::vector<OverrideSegment> segments;  // at least one
  std::string value;                      // without spaces around, not empty
};

// A name that holds a dot, '=' or bracket stands in quotes. Throws Error "place: what is wrong; what to do".
OverridePath parse_override(std::string_view text, std::string_view place);

}  // namespace scree::document
