#include "scenario_checks.hpp"

// The text of a scene.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return scree::fuzz::check_scene(scree::fuzz::text_of(data, size), {});
}
