#pragma once

#include <scree/error.hpp>

namespace scree::tool {

// Whether the arguments name a verb of the companion library scree_studies.
bool is_study(int argc, char** argv);

// Does what the arguments ask for with that library, which is loaded now and, in a build tree, built if it is missing.
// Throws Error if it cannot be.
ExitStatus run_study(int argc, char** argv);

}  // namespace scree::tool
