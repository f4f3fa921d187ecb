#include "folded_keys.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree::tool {

namespace {

std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  std::istringstream text(key);
  for (std::string part; std::getline(text, part, '_');) parts.push_back(part);
  return parts;
}

}  // namespace

std::string folded(const std::vector<std::string>& keys) {
  std::vector<std::vector<std::string>> choices;  // at each place, in the order of the keys
  bool alike = true;
  for (const std::string& key : keys) {
    const std::vector<std::string> parts = parts_of(key);
    if (choices.empty()) choices.resize(parts.size());
    alike = alike && parts.size() == choices.size();
    for (std::size_t k = 0; alike && k < parts.size(); ++k)
      if (std::find(choices[k].begin(), choices[k].end(), parts[k]) == choices[k].end())
        choices[k].push_back(parts[k]);
  }
  std::size_t combinations = 1;
  std::vector<std::string> text;
  for (const std::vector<std::string>& of_place : choices) {
    combinations *= of_place.size();
    text.push_back(of_place.size() == 1 ? of_place[0] : fmt::format("{{{}}}", fmt::join(of_place, ",")));
  }
  const std::set<std::string> different(keys.begin(), keys.end());
  if (!alike || combinations != different.size()) return fmt::format("{}", fmt::join(keys, ", "));
  return fmt::format("{}", fmt::join(text, "_"));
}

}  // namespace scree::tool
