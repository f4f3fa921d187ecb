#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <scree/document/document.hpp>

namespace scree::scenario {

// A file from which a scene takes its bodies: the key of [particles] that names it, and its absolute path.
struct BodyFile {
  std::string key;
  std::filesystem::path path;
};

// Absent if the scenario names none. Throws Error if it names a state that does not exist.
std::optional<BodyFile> body_file(const document::Document& document, const std::filesystem::path& scenario);

}  // namespace scree::scenario
