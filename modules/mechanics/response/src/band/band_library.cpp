#include "band/band_library.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/companion_library.hpp>

namespace scree::response {
namespace {

constexpr int built_levels[] = {SCREE_BAND_LEVELS};  // x86-64-v<n>, best first

bool is_supported(int level) {
#if defined(__x86_64__) && !defined(__clang__)  // clang 14 knows no levels
  if (level == 4) return __builtin_cpu_supports("x86-64-v4");
  if (level == 3) return __builtin_cpu_supports("x86-64-v3");
#endif
  return level == 1;
}

const BandBackendFactory* load_best() {
  for (const int level : built_levels) {
    if (!is_supported(level)) continue;
    const std::string target = fmt::format("scree_response_band_v{}", level);
    return files::load_companion<BandBackendFactory>(
        files::CompanionLibrary{.target = target.c_str(),
                                .factory = "scree_create_band_backend",
                                .purpose = "the linear response of packings",
                                .without = "use another method for the spectrum",
                                .needs = "the METIS run-time library"},
        band_backend_version);
  }
  throw Error(
      "the linear response of packings is not built for the instruction level of this processor; build all levels: "
      "cmake -DSCREE_LEVELS=all in the build directory, then build again, or tools/test");
}

}  // namespace

const BandBackendFactory& band_library() {
  static const BandBackendFactory* const library = load_best();
  return *library;
}

}  // namespace scree::response
