#pragma once

// Whether code is compiled for several instruction levels. Not with sanitizers: they do not support the
// selection by the loader, and compiling the kernel takes minutes per level. Not without optimisation:
// vectors would be passed to functions of another level.
#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define SCREE_SEVERAL_LEVELS 1
#else
#define SCREE_SEVERAL_LEVELS 0
#endif

// Compiles a function for every instruction level; the loader selects the best one. For loops whose results
// do not depend on the vector width. Only for functions that no other file calls: clang gives the clones a
// name that callers know from the definition alone.
#if SCREE_SEVERAL_LEVELS
#define SCREE_EVERY_LEVEL [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")]]
#else
#define SCREE_EVERY_LEVEL
#endif

// With what it calls. clang, which does not combine this with clones, decides itself what it inlines.
#if defined(__clang__)
#define SCREE_EVERY_LEVEL_INLINED SCREE_EVERY_LEVEL
#else
#define SCREE_EVERY_LEVEL_INLINED [[gnu::flatten]] SCREE_EVERY_LEVEL
#endif

#include <string>
#include <vector>

namespace scree {

// Folders of the builds that this processor supports, best first; "." is the baseline. The environment
// variable SCREE_LEVEL restricts the list to one level and the baseline. Throws Error if the processor does
// not support it.
std::vector<std::string> instruction_levels();

}  // namespace scree
