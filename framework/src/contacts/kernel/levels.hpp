#pragma once

#include "contacts/forces.hpp"
#include "plugins/instruction_levels.hpp"

#include <string>

// Choice of the build of a function template for the features of a scene and for an instruction level. Without
// contraction and reassociation all levels have the same bits.

#if SCREE_SEVERAL_LEVELS
#define SCREE_LEVELS(X)                \
  X(baseline, )                        \
  X(v3, gnu::target("arch=x86-64-v3")) \
  X(v4, gnu::target("arch=x86-64-v4,prefer-vector-width=512"))
#define SCREE_BEST_LEVEL(name, ...) \
  best_level(&name##_baseline<__VA_ARGS__>, &name##_v3<__VA_ARGS__>, &name##_v4<__VA_ARGS__>)
#else
#define SCREE_LEVELS(X) X(baseline, )
#define SCREE_BEST_LEVEL(name, ...) &name##_baseline<__VA_ARGS__>
#endif

namespace scree::kernel {

// The one that the processor supports, or that SCREE_LEVEL selects.
template <class Function>
Function best_level(Function baseline, Function v3, Function v4) {
  const std::string level = instruction_levels().front();
  return level == "x86-64-v4" ? v4 : level == "x86-64-v3" ? v3 : baseline;
}

// Calls use<D, spin, T>() for the dimension, spins and precision of a scene.
template <class Use>
void specialise(const Forces::Features& f, const Use& use) {
  const auto with_precision = [&]<int D, bool spin>() {
    if (f.precision == Precision::mixed)
      use.template operator()<D, spin, float>();
    else
      use.template operator()<D, spin, double>();
  };
  if (f.dimension == 2)
    f.spin ? with_precision.template operator()<2, true>() : with_precision.template operator()<2, false>();
  else
    f.spin ? with_precision.template operator()<3, true>() : with_precision.template operator()<3, false>();
}

}  // namespace scree::kernel
