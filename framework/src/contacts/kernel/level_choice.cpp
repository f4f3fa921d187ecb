#include "contacts/kernel/evaluate.hpp"
#include "contacts/kernel/plane_load.hpp"
#include "machine/instruction_levels.hpp"

#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::kernel {

namespace {

// The levels for which the hot loops are built.
using Built = std::integer_sequence<int, SCREE_KERNEL_LEVELS>;

std::string folder_of(int level) { return level == 1 ? "." : fmt::format("x86-64-v{}", level); }

// use<level>() returns the function compiled for a level.
template <class Function, class Use, int... built>
Function at_best_level(const Use& use, std::integer_sequence<int, built...>) {
  for (const std::string& supported : instruction_levels()) {
    Function function = nullptr;
    ((supported == folder_of(built) ? void(function = use.template operator()<built>()) : void()), ...);
    if (function) return function;
  }
  throw Error(
      "the kernel is not built for the instruction level of this processor or of SCREE_LEVEL; build all "
      "levels: cmake -DSCREE_LEVELS=all in the build directory, then build again, or tools/test");
}

}  // namespace

EvaluateTile tile_evaluation(const Forces::Features& features) {
  return at_best_level<EvaluateTile>([&]<int level>() { return tile_evaluation_at<level>(features); },
                                     Built());
}

EvaluatePlaneLoad plane_load_evaluation(const Forces::Features& features) {
  return at_best_level<EvaluatePlaneLoad>(
      [&]<int level>() { return plane_load_evaluation_at<level>(features); }, Built());
}

}  // namespace scree::kernel
