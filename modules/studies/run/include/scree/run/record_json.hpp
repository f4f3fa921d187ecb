#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace scree::run {

// The JSON of a record, such as run.json or campaign.json, without what is nested deeper than any program writes; discarded if
// it is not JSON.
inline nlohmann::ordered_json parse_record(const std::string& text) {
  constexpr int deepest = 32;
  const auto keep = [](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
    return depth < deepest;
  };
  return nlohmann::ordered_json::parse(text, keep, false);
}

}  // namespace scree::run
