#include "scenario_file.hpp"

#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>

namespace scree::run {

namespace {

namespace fs = std::filesystem;
using document::Document;

std::optional<std::string> body_path(const Document& document, const char* key) {
  if (!document.root().is_table("particles")) return std::nullopt;
  const document::Table particles = document.root().table("particles");
  return particles.is_string(key) ? particles.optional_string(key) : std::nullopt;
}

// The scenario with which results began, with the paths of the present file where they name the same file of bodies.
std::string with_paths_of(const Document& now, const std::string& began) {
  std::vector<std::string> paths;
  for (const char* key : {"file", "state"}) {
    const auto before = body_path(Document::parse(began, scenario_file), key), path = body_path(now, key);
    if (before && path && fs::path(*before).filename() == fs::path(*path).filename())
      paths.push_back(fmt::format("particles.{}=\"{}\"", key, files::escaped(*path, files::Escapes::toml)));
  }
  return Document::parse(began, scenario_file, paths).resolved_text();
}

}  // namespace

std::string restored_scenario(const fs::path& directory, const std::string& began,
                              const std::function<void(const std::string&)>& on_warning) {
  const fs::path file = directory / scenario_file;
  std::string restored = began;
  try {
    const Document now = Document::load(file);
    restored = with_paths_of(now, began);
    if (now.resolved_text() == restored) return "";
  } catch (const Error&) {
    // It was removed, or is no scenario any more.
  }
  if (on_warning)
    on_warning(fmt::format(
        "{}: is not the scenario with which these results began; they go on with that one, and the file is "
        "written anew; to change values, begin a new run from a state (particles.state)",
        file.string()));
  return restored;
}

}  // namespace scree::run
