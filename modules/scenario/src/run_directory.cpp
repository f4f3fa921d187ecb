#include <scree/scenario/run_directory.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include <scree/error.hpp>

namespace scree::scenario {

namespace fs = std::filesystem;

namespace {

// The nearest ancestor that exists.
fs::path existing_part(const fs::path& path) {
  std::error_code failed;
  fs::path p = fs::absolute(path, failed).lexically_normal();
  while (!p.empty() && !fs::exists(p, failed) && p != p.parent_path()) p = p.parent_path();
  return p;
}

}  // namespace

RunDirectory::RunDirectory(fs::path path, bool overwrite) : path_(std::move(path)) {
  std::error_code failed;
  const std::string name = path_.string();
  if (fs::exists(path_, failed)) {
    if (!fs::is_directory(path_, failed)) throw Error(fmt::format("{}: exists and is no directory; give another --out", name));
    const bool empty = fs::is_empty(path_, failed);
    const bool is_run = fs::exists(path_ / "run.json", failed);
    if (!empty && !is_run) throw Error(fmt::format("{}: holds files that are no run of scree; give another --out", name));
    if (!empty && !overwrite)
      throw Error(fmt::format("{}: holds a run already; give another --out, or --overwrite to replace it", name));
  }
  const fs::path parent = existing_part(path_);
  if (!fs::is_directory(parent, failed) || access(parent.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{}: cannot be written ({} is not a writable directory); give another --out", name, parent.string()));
}

void RunDirectory::create() const {
  std::error_code failed;
  for (const char* part : {"series", "snapshots", "images", "charts", "scenario.toml", "run.json", "final_packing.csv"})
    fs::remove_all(path_ / part, failed);
  fs::create_directories(path_, failed);
  if (failed) throw Error(fmt::format("{}: cannot be created ({}); give another --out", path_.string(), failed.message()));
}

void RunDirectory::write_file(const std::string& name, const std::string& text) const {
  const fs::path final_path = path_ / name, temporary = path_ / (name + ".part");
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code failed;
  if (file) fs::rename(temporary, final_path, failed);
  if (!file || failed) {
    fs::remove(temporary, failed);
    throw Error(fmt::format("{}: cannot be written; free disk space or give another --out", final_path.string()), ExitStatus::failure);
  }
}

fs::path RunDirectory::default_for(const fs::path& scenario) {
  const fs::path base = fs::path("runs") / scenario.stem();
  fs::path path = base;
  std::error_code failed;
  for (int k = 2; fs::exists(path, failed); ++k) path = fs::path(fmt::format("{}-{}", base.string(), k));
  return path;
}

}  // namespace scree::scenario
