#include "support/snapshot_files.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code failed;
  return fs::is_directory(path, failed);
}

std::vector<fs::path> snapshot_files(const fs::path& source) {
  if (!is_folder(source)) return {source};
  const fs::path folder = is_folder(source / "snapshots") ? source / "snapshots" : source;
  std::vector<fs::path> frames;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".vtp" && entry.path().filename().string().starts_with("particles_"))
      frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end());
  if (failed)
    throw Error(
        fmt::format("{}: cannot be read ({}); check its permissions", folder.string(), failed.message()));
  if (frames.empty())
    throw Error(
        fmt::format("{}: contains no particles_*.vtp; give a run with snapshots ([snapshot] every = <s>)",
                    source.string()));
  return frames;
}

bool has_snapshots(const fs::path& run) {
  std::error_code failed;
  return fs::exists(run / "snapshots/particles.pvd", failed);
}

}  // namespace scree::tool
