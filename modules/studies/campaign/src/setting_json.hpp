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

// The same for people: a string without its quotes, anything else as TOML.
inline std::string setting_text(const std::string& toml) {
  const Json json = setting_json(toml);
  return json.is_string() ? json.get<std::string>() : toml;
}

}  // namespace scree::campaign
