#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <scree/pictures/load_backend.hpp>

// A snapshot of bodies, as `scree render` reads it: in a child process, which may die.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scree_fuzz_vtp_" + std::to_string(getpid()));
  static const auto backend = scree::pictures::load_backend();
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "particles_0000000001.vtp";
  std::ofstream(file, std::ios::binary) << scree::fuzz::text_of(data, size);
  return scree::fuzz::accept_or_refuse([&] { backend->read_frame(file); });
}
