#pragma once

#include <scree/error.hpp>

namespace scree::tool {

// The interface of the companion library scree_studies, with the verbs that need what is not built for a run:
// accuracy, spectrum, cycles, fields, modes and quasi-static. The program itself has their options and help.
class Studies {
 public:
  virtual ~Studies() = default;
  // Does what the arguments of one of these verbs, or of `resume` for the results of a study, ask for.
  virtual ExitStatus run(int argc, char** argv) const = 0;
};
constexpr int studies_version = 1;

}  // namespace scree::tool
