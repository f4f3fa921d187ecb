#include <limits>

#include <nlohmann/json.hpp>

#include <scree/report/record.hpp>

namespace scree::report {

using Json = nlohmann::ordered_json;

Json parse_record(const std::string& text) {
  constexpr int deepest = 32;
  const auto keep = [](int depth, Json::parse_event_t, Json&) { return depth < deepest; };
  return Json::parse(text, keep, false);
}

namespace {

// Null if there is none.
const Json* entry(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

std::string text_in(const Json& object, const char* key) {
  const Json* value = entry(object, key);
  return value && value->is_string() ? value->get<std::string>() : "";
}

double number_in(const Json& object, const char* key) {
  const Json* value = entry(object, key);
  return value && value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

bool is_true_in(const Json& object, const char* key) {
  const Json* value = entry(object, key);
  return value && value->is_boolean() && value->get<bool>();
}

const Json& list_in(const Json& object, const char* key) {
  static const Json none = Json::array();
  const Json* value = entry(object, key);
  return value && value->is_array() ? *value : none;
}

const Json& object_in(const Json& object, const char* key) {
  static const Json none = Json::object();
  const Json* value = entry(object, key);
  return value && value->is_object() ? *value : none;
}

}  // namespace scree::report
