#include "plugin_values.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/error.hpp>

namespace scree::tool {

namespace {

Error wrong_value(const std::string& text, const std::string& problem, const std::string& cure) {
  return Error(fmt::format("'{}': {}; {}", text, problem, cure));
}

double number_of(const scree_parameter& p, const std::string& text, const std::string& word) {
  if (p.type == SCREE_CHOICE) {
    const auto words = choices_of(p);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return double(found - words.begin());
    throw wrong_value(text, fmt::format("'{}' is not a valid choice", word),
                      document::name_cure(word, words));
  }
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end)
    throw wrong_value(text, fmt::format("'{}' is not a number", word), "give a number such as 5e3");
  return value;
}

}  // namespace

void set_value(Parameters& parameters, const std::string& text) {
  const auto equals = text.find('=');
  const std::string key = text.substr(0, equals), name = parameters.plugin().name;
  if (equals == std::string::npos) throw wrong_value(text, "has no '='", "give KEY=VALUE");
  const scree_parameter* p = parameters.find(key);
  if (!p) {
    std::vector<std::string> keys;
    for (std::uint32_t k = 0; k < parameters.plugin().parameter_count; ++k)
      keys.push_back(parameters.plugin().parameters[k].key);
    throw wrong_value(text, fmt::format("{} has no parameter '{}'", name, key),
                      document::name_cure(key, keys));
  }
  const double value = number_of(*p, text, text.substr(equals + 1));
  parameters.set(key, p->type == SCREE_PROGRAM ? std::vector<double>{0, value} : std::vector<double>{value});
}

}  // namespace scree::tool
