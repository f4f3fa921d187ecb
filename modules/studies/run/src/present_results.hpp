#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/files/place_error.hpp>
#include <scree/run/run_directory.hpp>

// What is in a directory of results already.
namespace scree::run {

// Each kind of directory. The record identifies the kind; without a list of files, other files are `tables`.
struct Layout {
  const char *name, *record;
  std::vector<const char*> folders, tables;
};
const Layout& layout_of(RunDirectory::Kind kind);
// "a run", "an accuracy study"; "another run".
std::string with_article(const Layout& layout, const char* article = "a");

// The error of a directory that cannot be used.
files::PlaceError refusal(const std::filesystem::path& path, const std::string& problem,
                          const char* cure = "");

// Whether scree resume goes on with what is there.
bool goes_on(const std::filesystem::path& path, RunDirectory::Kind kind);

// Throws Error if what is there can be neither replaced nor kept, or is to be refused. The path exists.
void check_present(const std::filesystem::path& path, RunDirectory::Kind kind,
                   RunDirectory::Existing existing);

}  // namespace scree::run
