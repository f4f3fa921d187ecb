#include "scenario_checks.hpp"
#include "scene_text.hpp"

#include <sstream>

// Overrides of a valid scene, one in each line.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(std::string(scree::fuzz::text_of(data, size)));
  std::vector<std::string> overrides;
  for (std::string line; std::getline(lines, line);) overrides.push_back(line);
  return scree::fuzz::check_scene(scree::test::discs, overrides);
}
