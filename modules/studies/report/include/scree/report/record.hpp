#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

// The record of results, such as run.json or campaign.json, which anyone may have written.
namespace scree::report {

// The JSON of a record without what is nested deeper than any program writes; discarded if it is not JSON.
nlohmann::ordered_json parse_record(const std::string& text);

// The entry of an object if it has this type; otherwise an empty text, NaN, false, or an empty list or
// object.
std::string text_in(const nlohmann::ordered_json& object, const char* key);
double number_in(const nlohmann::ordered_json& object, const char* key);
bool is_true_in(const nlohmann::ordered_json& object, const char* key);
const nlohmann::ordered_json& list_in(const nlohmann::ordered_json& object, const char* key);
const nlohmann::ordered_json& object_in(const nlohmann::ordered_json& object, const char* key);

}  // namespace scree::report
