#include <algorithm>
#include <cerrno>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <scree/files/text_file.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

// Files and folders of each kind of directory; the last entry identifies the kind.
struct Layout {
  const char* name;
  std::vector<const char*> parts;
};
const Layout& layout_of(RunDirectory::Kind kind) {
  static const Layout run = {
      "run", {"series", "snapshots", "images", "charts", "scenario.toml", "final_packing.csv", "run.json"}};
  static const Layout study = {"accuracy study", {"charts", "accuracy.csv", "accuracy.json"}};
  static const Layout campaign = {"campaign", {"table.csv", "means.csv", "campaign.json"}};
  return kind == RunDirectory::Kind::run ? run : kind == RunDirectory::Kind::study ? study : campaign;
}

// The path itself, or its nearest parent directory that exists.
fs::path existing_part(const fs::path& path) {
  std::error_code failed;
  fs::path p = fs::absolute(path, failed).lexically_normal();
  while (!p.empty() && !fs::exists(p, failed) && p != p.parent_path()) p = p.parent_path();
  return p;
}

// True if there is nothing but the log and incomplete files of a killed write_file.
bool is_unused(const fs::path& path, const Layout& layout) {
  std::error_code failed;
  const auto is_partial = [&](const std::string& name) {
    return std::any_of(layout.parts.begin(), layout.parts.end(),
                       [&](const char* part) { return name == std::string(part) + files::part_suffix; });
  };
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (entry.path().filename() != RunDirectory::log_name && !is_partial(entry.path().filename().string()))
      return false;
  return !failed;
}

void check_present(const fs::path& path, const Layout& layout, bool overwrite) {
  std::error_code failed;
  const auto refuse = [&](const std::string& problem, const char* cure) {
    return Error(fmt::format("{}: {}; {}", path.string(), problem, cure));
  };
  if (!fs::is_directory(path, failed)) throw refuse("exists and is not a directory", "give another --out");
  if (fs::directory_iterator(path, failed); failed)
    throw refuse(fmt::format("cannot be read ({})", failed.message()),
                 "check its permissions, or give another --out");
  if (is_unused(path, layout)) return;
  if (!fs::exists(path / layout.parts.back(), failed))
    throw refuse(fmt::format("contains files that are not part of a scree {}", layout.name),
                 "give another --out");
  const char* article = layout.name[0] == 'a' ? "an" : "a";
  if (!overwrite)
    throw refuse(fmt::format("already contains {} {}", article, layout.name),
                 "give another --out, or --overwrite to replace it");
}

}  // namespace

RunDirectory::RunDirectory(fs::path path, bool overwrite, Kind kind)
    : path_(std::move(path)), existing_(existing_part(path_)), kind_(kind) {
  std::error_code failed;
  if (fs::exists(fs::symlink_status(path_, failed))) check_present(path_, layout_of(kind_), overwrite);
  if (!fs::is_directory(existing_, failed) || access(existing_.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{}: cannot be written ({} is not a writable directory); give another --out",
                            path_.string(), existing_.string()));
}

void RunDirectory::create() const {
  std::error_code failed;
  if (kind_ != Kind::campaign)
    for (const std::string part : layout_of(kind_).parts)
      fs::remove_all(path_ / part, failed), fs::remove(path_ / (part + files::part_suffix), failed);
  fs::create_directories(path_, failed);
  if (failed)
    throw Error(
        fmt::format("{}: cannot be created ({}); give another --out", path_.string(), failed.message()));
}

void RunDirectory::discard() const {
  std::error_code failed;
  for (const char* part : layout_of(kind_).parts) fs::remove_all(path_ / part, failed);
  // Removes only empty directories: another run may have created files there.
  for (fs::path p = fs::absolute(path_, failed).lexically_normal(); p != existing_ && p != p.parent_path();
       p = p.parent_path())
    fs::remove(p, failed);
}

void RunDirectory::write_file(const std::string& name, const std::string& text) const {
  try {
    files::write_atomically(path_ / name, text);
  } catch (const Error&) {
    throw unwritable(path_ / name);
  }
}

Error unwritable(const fs::path& path, int code) {
  std::string cure = "; free disk space or give another --out";
  if (code == EMFILE) cure = " (too many files are open); use fewer probes, or raise the limit (ulimit -n)";
  if (code == EFBIG) cure = " (it would be too large); raise the limit (ulimit -f) or sample less often";
  return Error(fmt::format("{}: cannot be written{}", path.string(), cure), ExitStatus::failure);
}

fs::path RunDirectory::default_for(const fs::path& scenario, Kind kind) {
  // The stems of "..toml" and "...toml" are directories that exist.
  const bool named = scenario.stem() != "." && scenario.stem() != "..";
  const fs::path name = named ? scenario.stem() : fs::path("scenario");
  if (kind == Kind::campaign) return "campaigns" / name;
  fs::path base = "runs" / name;
  if (kind == Kind::study) base += "-accuracy";
  fs::path path = base;
  std::error_code failed;
  for (int k = 2; fs::exists(path, failed); ++k) path = fs::path(fmt::format("{}-{}", base.string(), k));
  return path;
}

}  // namespace scree::run
