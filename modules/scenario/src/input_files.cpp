#include "particles_keys.hpp"
#include "readers.hpp"

namespace scree::scenario {

namespace fs = std::filesystem;

std::optional<BodyFile> body_file(const document::Document& document, const fs::path& scenario) {
  const document::Table root = document.root();
  if (!root.is_table("particles")) return std::nullopt;
  const document::Table particles = root.table("particles");
  const fs::path folder = scenario.parent_path();
  if (particles.is_string(particles_keys.state))
    return BodyFile{particles_keys.state.name, find_state(particles, folder)};
  if (!particles.is_string(particles_keys.file)) return std::nullopt;
  std::error_code failed;
  const auto file = fs::absolute(folder / read(particles, particles_keys.file), failed);
  return BodyFile{particles_keys.file.name, file.lexically_normal()};
}

std::map<std::string, fs::path> plugin_files(const document::Document& document, const PluginHost& host) {
  std::map<std::string, fs::path> files;
  const document::Table root = document.root();
  for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE, SCREE_PROBE}) {
    const std::string folder = kind_folder(kind);  // also the name of the table
    for (const document::Table& table : root.tables(folder)) {
      if (!table.is_string("plugin")) continue;
      const std::string name = table.string("plugin");
      files[folder + "/" + name] = host.locate(name, kind);
    }
  }
  return files;
}

InputFiles input_files(const document::Document& document, const fs::path& scenario, const PluginHost& host) {
  const auto bodies = body_file(document, scenario);
  return {bodies ? bodies->path : fs::path(), plugin_files(document, host)};
}

}  // namespace scree::scenario
