#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>

namespace scree {

std::vector<std::string> instruction_levels() {
  std::vector<std::string> all;
#if defined(__x86_64__) && !defined(__clang__)  // clang 14 knows no levels
  if (__builtin_cpu_supports("x86-64-v4")) all.push_back("x86-64-v4");
  if (__builtin_cpu_supports("x86-64-v3")) all.push_back("x86-64-v3");
#endif
  const char* chosen = std::getenv("SCREE_LEVEL");
  if (chosen && std::string(chosen) == "baseline") return {"."};
  if (chosen && *chosen && std::find(all.begin(), all.end(), chosen) == all.end())
    throw Error(fmt::format("SCREE_LEVEL={}: not supported by this processor; use {}baseline", chosen,
                            all.empty() ? "" : fmt::format("{} or ", fmt::join(all, ", "))));
  if (chosen && *chosen) return {chosen, "."};
  all.push_back(".");
  return all;
}

}  // namespace scree
