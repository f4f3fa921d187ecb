#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace scree::campaign {

using Json = nlohmann::ordered_json;

// A TOML value as JSON: numbers, strings, booleans and lists as themselves, anything else as its text.
inline Json setting_json(const std::string& toml) {
  Json json = Json::parse(toml, nullptr, false);
  return json.is_discarded() ? Json(toml) : json;
}

}  // namespace scree::campaign
