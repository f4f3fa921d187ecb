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

// True if there is nothing but the log, the lock and incomplete files of a killed write_file.
bool is_unused(const fs::path& path, const Layout& layout) {
  std::error_code failed;
  const auto is_partial = [&](const std::string& name) {
    return std::any_of(layout.parts.begin(), layout.parts.end(),
                       [&](const char* part) { return name == std::string(part) + files::part_suffix; });
  };
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (const std::string name = entry.path().filename().string();
        name != RunDirectory::log_name && name != files::DirectoryLock::file_name && !is_partial(name))
      return false;
  return !failed;
}

void check_present(const fs::path& path, const Layout& layout, RunDirectory::Existing existing) {
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
  if (existing == RunDirectory::Existing::refuse)
    throw refuse(fmt::format("already contains {} {}", article, layout.name),
                 "give another --out, or --overwrite to replace it");
}

Error in_use(const fs::path& path, const Layout& layout) {
  const char* another = layout.name[0] == 'a' ? "an" : "another";
  return Error(fmt::format("{}: {} {} is running there; wait for it or give another --out", path.string(),
                           another, layout.name));
}

}  // namespace

RunDirectory::RunDirectory(fs::path path, Existing existing, Kind kind)
    : path_(std::move(path)), existing_(existing), kind_(kind) {
  check();
}

RunDirectory::RunDirectory(fs::path path, Kind kind, files::DirectoryLock lock)
    : path_(std::move(path)), existing_(Existing::refuse), kind_(kind), lock_(std::move(lock)) {
  check();
}

RunDirectory RunDirectory::numbered(const fs::path& path, Kind kind) {
  for (int k = 1;; ++k) {
    const fs::path one = k == 1 ? path : fs::path(fmt::format("{}-{}", path.string(), k));
    if (auto lock = files::DirectoryLock::take_new(one)) return {one, kind, std::move(*lock)};
  }
}

void RunDirectory::check() const {
  std::error_code failed;
  if (fs::exists(fs::symlink_status(path_, failed))) check_present(path_, layout_of(kind_), existing_);
  const fs::path existing = existing_part(path_);
  if (!fs::is_directory(existing, failed) || access(existing.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{}: cannot be written ({} is not a writable directory); give another --out",
                            path_.string(), existing.string()));
}

void RunDirectory::take() {
  if (lock_) return;
  using Children = files::DirectoryLock::Children;
  auto lock = files::DirectoryLock::take(path_, kind_ == Kind::campaign ? Children::inherit : Children::none);
  if (!lock) throw in_use(path_, layout_of(kind_));
  lock_.emplace(std::move(*lock));
  check();  // another process may have written there before it was locked
}

void RunDirectory::create() {
  take();
  std::error_code failed;
  if (existing_ == Existing::keep) return;
  for (const std::string part : layout_of(kind_).parts)
    fs::remove_all(path_ / part, failed), fs::remove(path_ / (part + files::part_suffix), failed);
}

void RunDirectory::discard() {
  std::error_code failed;
  for (const char* part : layout_of(kind_).parts) fs::remove_all(path_ / part, failed);
  lock_.reset();
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
  fs::path path = "runs" / name;
  if (kind == Kind::study) path += "-accuracy";
  return path;
}

}  // namespace scree::run
