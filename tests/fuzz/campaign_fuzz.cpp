#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <scree/campaign/campaign.hpp>

// The text of a campaign file. Its scenario, if it names one that exists, is not run.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("scree_fuzz_campaign_" + std::to_string(getpid()) + ".toml");
  static const std::filesystem::path scene = std::filesystem::temp_directory_path() / "scene.toml";
  std::ofstream(scene) << "[scene]\ntitle = \"a scene\"\n";
  std::ofstream(file, std::ios::binary) << scree::fuzz::text_of(data, size);
  return scree::fuzz::accept_or_refuse([&] { scree::campaign::read_campaign(file); });
}
