#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <scree/files/place_error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/record_json.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

// Each kind of directory. The record identifies the kind; without a list of files, other files are `tables`.
struct Layout {
  const char *name, *record;
  std::vector<const char*> folders, tables;
};
const Layout& layout_of(RunDirectory::Kind kind) {
  static const Layout run = {"run", "run.json", {"series", "snapshots", "images", "charts"}, {}};
  static const Layout accuracy = {"accuracy study", "accuracy.json", {"charts"}, {}};
  static const Layout campaign = {"campaign", "campaign.json", {}, {"table.csv", "means.csv"}};
  static const Layout spectrum = {"spectrum", "spectrum.json", {"charts"}, {}};
  static const Layout modes = {"table of modes", "modes.json", {"charts", "images"}, {}};
  static const Layout quasi_static = {"quasi-static load", "quasi_static.json", {"charts"}, {}};
  switch (kind) {
    case RunDirectory::Kind::run:
      return run;
    case RunDirectory::Kind::accuracy:
      return accuracy;
    case RunDirectory::Kind::campaign:
      return campaign;
    case RunDirectory::Kind::modes:
      return modes;
    case RunDirectory::Kind::quasi_static:
      return quasi_static;
    default:
      return spectrum;
  }
}

// The path itself, or its nearest parent directory that exists.
fs::path existing_part(const fs::path& path) {
  std::error_code failed;
  fs::path p = fs::absolute(path, failed).lexically_normal();
  while (!p.empty() && !fs::exists(p, failed) && p != p.parent_path()) p = p.parent_path();
  return p;
}

// Whether a list is of another origin: it is not empty and does not list the record.
bool is_foreign_list(const fs::path& path, const Layout& layout) {
  const WrittenFiles written(path);
  return !written.empty() && !written.contains(layout.record);
}

// True if there is nothing but the log, the lock, the list and incomplete files of a process killed at its start.
bool is_unused(const fs::path& path, const Layout& layout) {
  std::set<std::string> known = {RunDirectory::log_name, files::DirectoryLock::file_name,
                                 WrittenFiles::file_name, std::string(layout.record) + files::part_suffix};
  for (const std::string table : layout.tables) known.insert(table + files::part_suffix);
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (!known.contains(entry.path().filename().string())) return false;
  return !failed && !is_foreign_list(path, layout);
}

files::PlaceError refusal(const fs::path& path, const std::string& problem, const char* cure = "") {
  return files::PlaceError(path.string(), problem, cure, ExitStatus::bad_input,
                           "give the directory of one that was interrupted");
}

std::string with_article(const Layout& layout, const char* article = "a") {
  return fmt::format("{} {}", layout.name[0] == 'a' ? "an" : article, layout.name);
}

// Where files are listed, only those can be replaced.
void check_list(const fs::path& path, const Layout& layout) {
  std::error_code failed;
  for (const char* folder : layout.folders)
    if (fs::is_symlink(fs::symlink_status(path / folder, failed)))
      throw refusal(path / folder, "is a symbolic link, which is not followed", "remove it");
  if (WrittenFiles(path).contains(layout.record)) return;
  if (fs::exists(path / layout.record, failed))
    throw refusal(
        path,
        fmt::format(
            "contains {} without {}, the list of its files, so that it can be neither replaced nor resumed",
            with_article(layout), WrittenFiles::file_name),
        "move it elsewhere");
  throw refusal(path, fmt::format("contains files that are not part of a scree {}", layout.name));
}

// Whether there is a state from which results go on.
bool has_state(const fs::path& path, RunDirectory::Kind kind) {
  std::error_code failed;
  if (kind != RunDirectory::Kind::run) return fs::exists(path / "state.h5", failed);
  const fs::directory_iterator states(path / WrittenFiles::states_folder, failed);
  return std::any_of(begin(states), end(states),
                     [](const auto& entry) { return entry.path().extension() == ".h5"; });
}

// Whether scree resume goes on with what is there.
bool goes_on(const fs::path& path, RunDirectory::Kind kind) {
  if (kind == RunDirectory::Kind::accuracy || kind == RunDirectory::Kind::campaign) return false;
  if (kind != RunDirectory::Kind::run && !has_state(path, kind)) return false;
  try {
    const auto record = parse_record(files::read_text(path / layout_of(kind).record));
    if (!record.is_object() || !record.contains("status")) return false;
    // "running" where it was killed; "failed" also where the disk was full.
    return record["status"] == "interrupted" || record["status"] == "running" ||
           (record["status"] == "failed" && has_state(path, kind));
  } catch (const Error&) {  // it cannot be read
    return false;
  }
}

void check_present(const fs::path& path, RunDirectory::Kind kind, RunDirectory::Existing existing) {
  const Layout& layout = layout_of(kind);
  std::error_code failed;
  if (!fs::is_directory(path, failed)) throw refusal(path, "exists and is not a directory");
  if (fs::directory_iterator(path, failed); failed)
    throw refusal(path, fmt::format("cannot be read ({})", failed.message()), "check its permissions");
  if (is_unused(path, layout)) return;
  if (kind != RunDirectory::Kind::campaign)
    check_list(path, layout);
  else if (!fs::exists(path / layout.record, failed))
    throw refusal(path, fmt::format("contains files that are not part of a scree {}", layout.name));
  if (existing == RunDirectory::Existing::refuse)
    throw Error(fmt::format(
        "{}: already contains {}; {}give another --out, or --overwrite to replace it", path.string(),
        with_article(layout),
        goes_on(path, kind) ? fmt::format("go on with it: scree resume {}, or ", path.string()) : ""));
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
