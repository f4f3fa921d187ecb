#pragma once

#include <string>
#include <vector>

namespace scree {

// Folders of builds that this processor runs, best first; "." is the one that runs everywhere. The
// environment variable SCREE_LEVEL names the only one to be used before ".". Throws Error where the processor
// lacks it.
std::vector<std::string> instruction_levels();

}  // namespace scree
