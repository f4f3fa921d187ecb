#include "document_file.hpp"

#include "document_message.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::document {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 4096;

std::string shown(const fs::path& path) {
  return path.empty() ? "''" : files::one_line(path.string(), longest_path);
}

Error unreadable(const fs::path& path, std::string_view reason, std::string_view cure) {
  return Error(fmt::format("{}: cannot be read ({}); {}", shown(path), reason, cure));
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

Error failed(const fs::path& path, int code) {
  const std::string reason = std::generic_category().message(code);
  if (code == EISDIR) return unreadable(path, reason, directory_cure(path));
  if (code == ENOENT || code == ENOTDIR) return unreadable(path, reason, missing_cure(path));
  if (code == EACCES || code == EPERM) return unreadable(path, reason, "grant yourself the right to read it");
  return unreadable(path, reason, "check the path and the disk");
}

void check_text(const fs::path& path, std::string_view text) {
  const bool wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (wide) throw unreadable(path, "UTF-16 text", "save it as UTF-8");
  if (text.find('\0') != std::string_view::npos) {
    throw unreadable(path, "a binary file", "give a scene as TOML text");
  }
}

}  // namespace

std::string read_text_file(const fs::path& path, std::size_t largest) {
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw failed(path, errno);
  std::string text;
  std::vector<char> block(1u << 16);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block.data(), count);
    if (text.size() > largest) {
      throw unreadable(path, fmt::format("larger than {} MiB", largest >> 20),
                       "give a scene; many particles belong in a packing file");
    }
  }
  if (std::ferror(file.get()) != 0) throw failed(path, errno);
  check_text(path, text);
  return text;
}

}  // namespace scree::document
