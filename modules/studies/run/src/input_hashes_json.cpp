#include <nlohmann/json.hpp>

#include <scree/run/input_hashes_json.hpp>

namespace scree::run {

using Json = nlohmann::ordered_json;

Json json_of(const InputHashes& hashes) {
  Json json = Json::object();
  if (!hashes.bodies.empty()) json["bodies"] = hashes.bodies;
  json["plugins"] = Json(hashes.plugins);
  return json;
}

InputHashes input_hashes_of(const Json& json) { return {json.value("bodies", ""), json.at("plugins")}; }

}  // namespace scree::run
