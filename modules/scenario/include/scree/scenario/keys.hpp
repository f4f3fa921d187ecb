#pragma once

#include <string>
#include <vector>

namespace scree::scenario {

// One key of a table of a scenario, as the readers check it.
struct KeyDescription {
  std::string name;
  std::string value;   // "number (s) above 0", "true or false", "\"png\", \"svg\""
  std::string absent;  // what holds without it: "required", "optional", "default 3"
  std::string doc;
};

struct TableDescription {
  std::string name;    // "time", "particles.lattice"
  std::string header;  // as written in a scenario: "[time]", "[[stage]]", "until = { }"
  std::string doc;
  std::vector<KeyDescription> keys;
};

}  // namespace scree::scenario
