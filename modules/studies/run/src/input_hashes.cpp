#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/content_hash.hpp>
#include <scree/run/input_hashes.hpp>

namespace scree::run {

InputHashes hashes_of(const scenario::InputFiles& files) {
  InputHashes hashes;
  std::string bodies;
  for (const std::filesystem::path& file : files.bodies) bodies += files::file_hash(file);
  hashes.bodies = files.bodies.size() > 1 ? files::text_hash(bodies) : bodies;
  for (const auto& [name, path] : files.plugins) hashes.plugins[name] = files::file_hash(path);
  return hashes;
}

InputHashes transfer_inputs(const StateTransfer& state, const InputHashes& now) {
  InputHashes inputs = state.restoring() ? InputHashes() : now;
  std::vector<std::string> names, hashes;
  for (const auto& [name, hash] : inputs.plugins) names.push_back(name), hashes.push_back(hash);
  if (!state.has("names")) return inputs;
  state.value("bodies", "", inputs.bodies);
  state.rows("names", "", names);
  hashes.resize(names.size());
  state.sized_rows("hashes", "", hashes);
  for (std::size_t k = 0; k < names.size(); ++k) inputs.plugins[names[k]] = hashes[k];
  return inputs;
}

InputHashes inputs_after(const InputHashes& before, const InputHashes& now,
                         const std::function<void(const std::string& warning)>& warn) {
  InputHashes inputs = before;
  for (const auto& [name, hash] : now.plugins) {
    const auto found = before.plugins.find(name);
    if (found == before.plugins.end() || found->second == hash) continue;
    inputs.plugins[name] = "several";
    if (found->second != "several")
      warn(fmt::format(
          "the library of the plug-in {} is not that with which the run began; run the scenario again "
          "if its results may differ",
          name));
  }
  return inputs;
}

nlohmann::ordered_json json_of(const InputHashes& hashes) {
  auto json = nlohmann::ordered_json::object();
  if (!hashes.bodies.empty()) json["bodies"] = hashes.bodies;
  json["plugins"] = nlohmann::ordered_json(hashes.plugins);
  return json;
}

InputHashes input_hashes_of(const nlohmann::ordered_json& json) {
  return {json.value("bodies", ""), json.at("plugins")};
}

}  // namespace scree::run
