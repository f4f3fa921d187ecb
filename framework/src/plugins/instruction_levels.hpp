#pragma once

// Whether code is compiled for several instruction levels. Sanitizers cannot follow the loader's choice of
// one, and take minutes for each of the kernel's.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SCREE_SEVERAL_LEVELS 1
#else
#define SCREE_SEVERAL_LEVELS 0
#endif

// A function compiled for every instruction level, of which the loader takes the best; for loops whose bits
// do not depend on the width of vectors.
#if SCREE_SEVERAL_LEVELS
#define SCREE_EVERY_LEVEL [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")]]
#else
#define SCREE_EVERY_LEVEL
#endif

#include <string>
#include <vector>

namespace scree {

// Folders of builds that this processor runs, best first; "." is the one that runs everywhere. The
// environment variable SCREE_LEVEL names the only one to be used before ".". Throws Error where the processor
// lacks it.
std::vector<std::string> instruction_levels();

}  // namespace scree
