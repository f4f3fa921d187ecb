#include "band_library.hpp"

#include <scree/files/companion_library.hpp>

namespace scree::response {

const BandBackendFactory& band_library() {
  const auto load = [](const char* target) {
    return files::load_companion<BandBackendFactory>(
        files::CompanionLibrary{.target = target,
                                .factory = "scree_create_band_backend",
                                .purpose = "the linear response of packings",
                                .without = "take another road to a spectrum",
                                .needs = "the METIS run-time library"},
        band_backend_version);
  };
#if defined(SCREE_BAND_LEVELS)
  static const BandBackendFactory* const library =
      load(__builtin_cpu_supports("x86-64-v4")   ? "scree_response_band_x86-64-v4"
           : __builtin_cpu_supports("x86-64-v3") ? "scree_response_band_x86-64-v3"
                                                 : "scree_response_band");
#else
  static const BandBackendFactory* const library = load("scree_response_band");
#endif
  return *library;
}

}  // namespace scree::response
