#pragma once

#include "support/command_line.hpp"

#include <array>

namespace scree::tool {

// A verb that the companion library scree_studies implements: what it needs is not built for a run.
struct StudyVerb {
  const char* name;
  const char* help;
};

inline constexpr std::array study_verbs = {
    StudyVerb{"accuracy",
              "Compare run time and error of a scenario for several steps, integrators and precisions"},
    StudyVerb{"spectrum",
              "Response of a packing to a driven wall over frequency; or the lines of a time series"},
    StudyVerb{"cycles", "Strain over the cycles of a load: ratcheting, shakedown, creep or none of them"},
    StudyVerb{"modes",
              "Modes and elastic constants of a packing at rest, and its straight paths under growing loads"},
    StudyVerb{"quasi-static", "The last stage of a scenario through states of equilibrium, without dynamics"},
};

// The interface of that library.
class Studies {
 public:
  virtual ~Studies() = default;
  // Does what the arguments of a study verb, or of `resume` for the results of a study, ask for.
  virtual ExitStatus run(int argc, char** argv) const = 0;
};
constexpr int studies_version = 1;

}  // namespace scree::tool
