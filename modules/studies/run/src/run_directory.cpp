#include "present_results.hpp"

#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <scree/files/place_error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

// The path itself, or its nearest parent directory that exists.
fs::path existing_part(const fs::path& path) {
  std::error_code failed;
  fs::path p = fs::absolute(path, failed).lexically_normal();
  while (!p.empty() && !fs::exists(p, failed) && p != p.parent_path()) p = p.parent_path();
  return p;
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

RunDirectory RunDirectory::of_results(const fs::path& out, bool overwrite, const fs::path& scenario,
                                      const std::vector<fs::path>& inputs, Kind kind) {
  if (out.empty()) return numbered(default_for(scenario, kind), kind);
  RunDirectory directory(out, overwrite ? Existing::replace : Existing::refuse, kind);
  directory.protect(inputs);
  directory.take();
  return directory;
}

void RunDirectory::check() const {
  std::error_code failed;
  if (fs::exists(fs::symlink_status(path_, failed))) check_present(path_, kind_, existing_);
  const fs::path existing = existing_part(path_);
  if (!fs::is_directory(existing, failed) || access(existing.c_str(), W_OK | X_OK) != 0)
    throw files::PlaceError(
        path_.string(), fmt::format("cannot be written ({} is not a writable directory)", existing.string()),
        "");
}

void RunDirectory::take() {
  if (lock_) return;
  using Children = files::DirectoryLock::Children;
  auto lock = files::DirectoryLock::take(path_, kind_ == Kind::campaign ? Children::inherit : Children::none);
  if (!lock)
    throw refusal(path_, fmt::format("{} is running there", with_article(layout_of(kind_), "another")),
                  "wait for it");
  lock_.emplace(std::move(*lock));
  check();  // another process may have written there before it was locked
}

void RunDirectory::protect(const std::vector<fs::path>& inputs) const {
  std::error_code failed;
  const fs::path directory = fs::canonical(path_, failed);
  if (failed) return;  // it is not there
  const WrittenFiles written(path_);
  for (const fs::path& input : inputs)
    if (written.contains(fs::canonical(input, failed).lexically_relative(directory).string()))
      throw refusal(
          input,
          fmt::format("is read by this scene and a file of the {} in {}, which would be removed first",
                      layout_of(kind_).name, path_.string()),
          "copy it elsewhere");
}

void RunDirectory::create() {
  take();
  if (kind_ == Kind::campaign) return;
  written_ = std::make_unique<WrittenFiles>(path_);
  if (existing_ != Existing::keep) written_->return_to(0);
}

void RunDirectory::begin(const std::function<void()>& open) {
  create();
  try {
    open();
  } catch (const std::exception&) {
    discard();
    throw;
  }
}

void RunDirectory::discard() {
  try {
    if (written_) written_->return_to(0);
  } catch (const Error&) {
    // The error for which the directory is discarded is the one to report.
  }
  lock_.reset();
}

void RunDirectory::report_lock(const std::function<void(const std::string&)>& on_warning) const {
  if (!on_warning || !lock_ || lock_->excludes()) return;
  on_warning(fmt::format(
      "{}: its file system has no locks, so that another process may replace what is written there; let no other scree "
      "write there until this one has ended, or give a directory on another file system",
      path_.string()));
}

void RunDirectory::check_in_place() const {
  if (!lock_ || lock_->is_current()) return;
  const std::string name = layout_of(kind_).name;
  if (const fs::path there = lock_->moved_to(); !there.empty())
    throw Error(
        fmt::format("{}: was moved to {} while the {} was written, and what was to follow is lost; {}",
                    path_.string(), there.string(), name,
                    goes_on(there, kind_) ? fmt::format("go on with it: scree resume {}", there.string())
                                          : "start it again"),
        ExitStatus::failure);
  throw Error(
      fmt::format(
          "{}: it or its file {} was removed while the {} was written, and with it the results so far; "
          "start it again",
          path_.string(), files::DirectoryLock::file_name, name),
      ExitStatus::failure);
}

fs::path RunDirectory::add(const std::string& name) const {
  check_in_place();
  return written_->add(name);
}

void RunDirectory::write_file(const std::string& name, const std::string& text) const {
  check_in_place();
  const fs::path path = written_ ? add(name) : path_ / name;
  std::error_code failed;  // a folder that is missing is reported with the file
  fs::create_directories(path.parent_path(), failed);
  try {
    files::write_atomically(path, text);
  } catch (const files::WriteError& error) {
    throw_unwritable(path, error.code());
  }
}

void throw_unwritable(const fs::path& path, int code) {
  const std::string problem = "cannot be written";
  const auto failure = ExitStatus::failure;
  for (const fs::path& place : {path, fs::path(path) += files::part_suffix})
    if (std::error_code failed; fs::is_directory(fs::symlink_status(place, failed)))
      throw files::PlaceError(place.string(), "is a directory in the place of a file", "move it elsewhere",
                              failure);
  if (code == EMFILE)
    throw Error(path.string(), problem + " (too many files are open)",
                "use fewer probes, or raise the limit (ulimit -n)", failure);
  if (code == EFBIG)
    throw Error(path.string(), problem + " (it would be too large)",
                "raise the limit (ulimit -f) or sample less often", failure);
  if (code == EACCES || code == EPERM || code == EROFS || code == ENOENT || code == ENOTDIR || code == ELOOP)
    throw files::PlaceError(path.string(), fmt::format("{} ({})", problem, std::strerror(code)),
                            "check its folder and its permissions", failure);
  throw files::PlaceError(path.string(), problem, "free disk space", failure);
}

fs::path RunDirectory::default_for(const fs::path& scenario, Kind kind) {
  // The stems of "..toml" and "...toml" are directories that exist.
  const bool named = scenario.stem() != "." && scenario.stem() != "..";
  const fs::path name = named ? scenario.stem() : fs::path("scenario");
  if (kind == Kind::campaign) return "campaigns" / name;
  fs::path path = "runs" / name;
  if (kind == Kind::accuracy) path += "-accuracy";
  if (kind == Kind::spectrum) path += "-spectrum";
  if (kind == Kind::modes) path += "-modes";
  if (kind == Kind::quasi_static) path += "-quasi-static";
  return path;
}

}  // namespace scree::run
