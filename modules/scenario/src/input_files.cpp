#include "particles_keys.hpp"
#include "readers.hpp"

namespace scree::scenario {

namespace fs = std::filesystem;

std::vector<BodyFile> body_files(const document::Document& document, const fs::path& scenario) {
  std::vector<BodyFile> files;
  const fs::path folder = scenario.parent_path();
  std::error_code failed;
  for (const document::Table& particles : document.root().tables("particles")) {
    const auto add = [&](const document::Table& table, const Key& key, const fs::path& path) {
      files.push_back({table.path() + "." + key.name, path});
    };
    const auto add_file = [&](const document::Table& table, const StringKey& key) {
      if (table.is_string(key))
        add(table, key, fs::absolute(folder / read(table, key), failed).lexically_normal());
    };
    if (particles.is_string(particles_keys.state))
      add(particles, particles_keys.state, find_state(particles, folder));
    else
      add_file(particles, particles_keys.file);
    if (particles.is_table(particles_keys.springs))
      add_file(particles.table(particles_keys.springs), springs_keys.file);
  }
  // Of boundaries, only meshes have such a string.
  for (const document::Table& boundary : document.root().tables("boundary"))
    if (boundary.is_string("file"))
      files.push_back({boundary.path() + ".file",
                       fs::absolute(folder / boundary.string("file"), failed).lexically_normal()});
  return files;
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
  InputFiles files = {{}, plugin_files(document, host)};
  for (const BodyFile& file : body_files(document, scenario)) files.bodies.push_back(file.path);
  return files;
}

}  // namespace scree::scenario
