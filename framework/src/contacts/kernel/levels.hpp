#pragma once

#include "contacts/forces.hpp"

// The hot loops are compiled once for each instruction level x86-64-v<n>, 1 being the baseline, in targets of
// their own (framework/CMakeLists.txt) that define SCREE_KERNEL_LEVEL as n. Without contraction and
// reassociation all levels have the same bits.

// An attribute selects the instructions, not an option of the compiler: inline functions of other headers, of
// which the linker keeps one copy for all levels, must run on every processor.
#if SCREE_KERNEL_LEVEL == 4
#define SCREE_AT_KERNEL_LEVEL [[gnu::flatten, gnu::target("arch=x86-64-v4,prefer-vector-width=512")]]
#elif SCREE_KERNEL_LEVEL == 3
#define SCREE_AT_KERNEL_LEVEL [[gnu::flatten, gnu::target("arch=x86-64-v3")]]
#else
#define SCREE_AT_KERNEL_LEVEL [[gnu::flatten]]
#endif

namespace scree::kernel {

// Calls use<D, spin>() for the dimension and spins of a scene.
template <class Use>
void specialise(const Forces::Features& f, const Use& use) {
  if (f.dimension == 2)
    f.spin ? use.template operator()<2, true>() : use.template operator()<2, false>();
  else
    f.spin ? use.template operator()<3, true>() : use.template operator()<3, false>();
}

}  // namespace scree::kernel
