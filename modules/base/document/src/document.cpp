#include "tree.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/nearest.hpp>

namespace scree::document {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 4096;

std::string shown(const fs::path& path) {
  return path.empty() ? "''" : files::one_line(path.string(), longest_path);
}

Error unreadable(const fs::path& path, std::string_view reason, std::string_view cure) {
  return {shown(path), fmt::format("cannot be read ({})", reason), std::string(cure)};
}

std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::vector<fs::path> scenes;
  std::error_code failure;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    if (entry->path().extension() == ".toml") scenes.push_back(folder / entry->path().filename());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::string missing_cure(const fs::path& path) {
  const std::vector<fs::path> scenes = scenes_in(path.parent_path());
  std::vector<std::string> stems;
  for (const fs::path& scene : scenes) stems.push_back(scene.stem().string());
  const auto near = nearest_word(path.stem().string(), stems);
  if (!near) return "check the path";
  const auto at = std::find(stems.begin(), stems.end(), *near) - stems.begin();
  return fmt::format("did you mean '{}'?", shown(scenes[static_cast<std::size_t>(at)]));
}

std::string directory_cure(const fs::path& path) {
  const std::vector<fs::path> scenes = scenes_in(path);
  return scenes.empty() ? "give a .toml file"
                        : fmt::format("give a file in it, such as {}", shown(scenes.front()));
}

Error unreadable(const fs::path& path, int code) {
  if (code == EFBIG) {
    return unreadable(path, fmt::format("larger than {} MiB", Document::largest_file >> 20),
                      "give a scene; many particles belong in a packing file");
  }
  const std::string reason = std::generic_category().message(code);
  if (code == EISDIR) return unreadable(path, reason, directory_cure(path));
  if (code == ENOENT || code == ENOTDIR) return unreadable(path, reason, missing_cure(path));
  if (code == EACCES || code == EPERM) return unreadable(path, reason, "grant yourself the right to read it");
  return unreadable(path, reason, "check the path and the disk");
}

std::string read_scene(const fs::path& path) {
  std::string text;
  try {
    text = files::read_text(path, Document::largest_file);
  } catch (const files::ReadError& error) {
    throw unreadable(path, error.code());
  }
  const bool wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (wide) throw unreadable(path, "UTF-16 text", "save it as UTF-8");
  if (text.find('\0') != std::string::npos)
    throw unreadable(path, "a binary file", "give a scene as TOML text");
  return text;
}

}  // namespace

Document Document::load(const fs::path& path, const std::vector<std::string>& overrides,
                        std::string_view cure) {
  Document document = parse(read_scene(path), path.string(), overrides);
  if (!document.state_->root.empty()) return document;
  throw document.root().error("the file holds no key", cure);
}

Document Document::parse(std::string_view text, std::string_view name,
                         const std::vector<std::string>& overrides) {
  auto state = std::make_shared<DocumentState>();
  state->name = files::one_line(name, longest_path);
  state->root = parse_text(text, state->name);
  for (const std::string& override_text : overrides) apply_override(*state, override_text);
  return Document(std::move(state));
}

Table Document::root() const {
  return Table(std::shared_ptr<TableState>(state_, &state_->state_of(state_->root)));
}

std::string Document::resolved_text() const { return document_text(*state_); }

const std::string& Document::conflict() const { return state_->conflict; }

}  // namespace scree::document
