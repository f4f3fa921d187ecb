#include "present_results.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/result_kind.hpp>

namespace scree::run {

namespace fs = std::filesystem;

const Layout& layout_of(RunDirectory::Kind kind) {
  static const Layout run = {
      run_results.noun, run_results.record, {"series", "snapshots", "images", "charts", "fields"}, {}};
  static const Layout accuracy = {accuracy_results.noun, accuracy_results.record, {"charts"}, {}};
  static const Layout campaign = {"campaign", "campaign.json", {}, {"table.csv", "means.csv"}};
  static const Layout spectrum = {spectrum_results.noun, spectrum_results.record, {"charts"}, {}};
  static const Layout modes = {modes_results.noun, modes_results.record, {"charts", "images"}, {}};
  static const Layout quasi_static = {quasi_static_results.noun, quasi_static_results.record, {"charts"}, {}};
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

files::PlaceError refusal(const fs::path& path, const std::string& problem, const char* cure) {
  return files::PlaceError(path.string(), problem, cure, ExitStatus::bad_input,
                           "give the directory of one that was interrupted");
}

std::string with_article(const Layout& layout, const char* article) {
  return fmt::format("{} {}", layout.name[0] == 'a' ? "an" : article, layout.name);
}

namespace {

// Whether a list is of another origin: it is not empty and does not list the record.
bool is_foreign_list(const fs::path& path, const Layout& layout) {
  const WrittenFiles written(path);
  return !written.empty() && !written.contains(layout.record);
}

// True if there is nothing but the log, the lock, the list and incomplete files of a process killed at its
// start.
bool is_unused(const fs::path& path, const Layout& layout) {
  std::set<std::string> known = {RunDirectory::log_name, files::DirectoryLock::file_name,
                                 WrittenFiles::file_name, std::string(layout.record) + files::part_suffix};
  for (const std::string table : layout.tables) known.insert(table + files::part_suffix);
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path, failed))
    if (!known.contains(entry.path().filename().string())) return false;
  return !failed && !is_foreign_list(path, layout);
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

}  // namespace

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

bool has_results(const fs::path& directory, const ResultKind& kind) {
  std::error_code failed;
  return fs::exists(directory / kind.record, failed);
}

}  // namespace scree::run
