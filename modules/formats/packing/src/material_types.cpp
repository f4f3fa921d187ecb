#include "material_types.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::packing {

using files::quote_token;
using files::TextReader;
using files::Token;

namespace {

// The name as a type number; empty unless it is a positive integer up to the maximum, without leading zeros.
std::optional<std::int64_t> as_type(const std::string& name) {
  std::int64_t value = 0;
  std::from_chars(name.data(), name.data() + name.size(), value);
  const bool canonical = value > 0 && value <= max_type && fmt::to_string(value) == name;
  return canonical ? std::optional(value) : std::nullopt;
}

std::vector<std::string> names_in_order(const Packing& packing) {
  std::vector<std::string> names;
  std::unordered_map<std::string, bool> seen;
  for (const Body& body : packing.bodies)
    if (seen.emplace(body.material, true).second) names.push_back(body.material);
  return names;
}

}  // namespace

std::string material_of_type(const Token& token, const std::vector<std::string>& materials,
                             const TextReader& reader) {
  const std::int64_t type = reader.positive_integer(token, "type");
  if (materials.empty()) return fmt::to_string(type);
  if (type > std::int64_t(materials.size()))
    reader.fail(token.column,
                fmt::format("type {} has no material: the list has only {}", type, materials.size()),
                "name a material for every type of the file");
  return materials[std::size_t(type - 1)];
}

std::string material_of_number(const Token& token, std::string_view what,
                               const std::vector<std::string>& materials, const TextReader& reader) {
  const std::int64_t number = reader.integer(token, what);
  if (number < 0 || number >= max_type)
    reader.fail(token.column, fmt::format("{} {} is not 0 to {}", what, number, max_type - 1), "correct it");
  if (materials.empty()) return fmt::to_string(number + 1);
  if (number >= std::int64_t(materials.size()))
    reader.fail(token.column,
                fmt::format("{} {} has no material: counted from 0, the scene has only {}", what, number,
                            materials.size()),
                "add a [[material]] for each number of the file, or leave the column out");
  return materials[std::size_t(number)];
}

MaterialTypes::MaterialTypes(const Packing& packing, const std::vector<std::string>& materials) {
  const std::vector<std::string> used = names_in_order(packing);
  const bool numbers = std::all_of(used.begin(), used.end(),
                                   [](const std::string& name) { return name.empty() || as_type(name); });
  if (materials.empty() && numbers) {
    for (const std::string& name : used) {
      const std::int64_t type = name.empty() ? 1 : *as_type(name);
      type_of_.emplace(name, type);
      count_ = std::max(count_, type);
    }
    return;
  }
  for (const std::string& name : materials.empty() ? used : materials)
    type_of_.emplace(name, std::int64_t(type_of_.size()) + 1);
  if (!materials.empty()) type_of_.emplace("", 1);
  count_ = std::int64_t(materials.empty() ? used.size() : materials.size());
  for (const std::string& name : used) {
    if (type_of_.contains(name)) continue;
    throw Error("packing", fmt::format("material {} has no type number", quote_token(name)),
                "add it to the listed materials");
  }
}

}  // namespace scree::packing
