#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

double read(const document::Table& table, const NumberKey& key) {
  return key.fallback ? table.number(key.name, *key.fallback, key.range) : table.number(key.name, key.range);
}

std::int64_t read(const document::Table& table, const IntegerKey& key) {
  return key.fallback ? table.integer(key.name, *key.fallback, key.range)
                      : table.integer(key.name, key.range);
}

bool read(const document::Table& table, const BooleanKey& key) {
  return key.fallback ? table.boolean(key.name, *key.fallback) : table.boolean(key.name);
}

std::string read(const document::Table& table, const StringKey& key) {
  return key.fallback ? table.string(key.name, *key.fallback) : table.string(key.name);
}

std::string read(const document::Table& table, const ChoiceKey& key) {
  return key.fallback ? table.choice(key.name, key.words, *key.fallback) : table.choice(key.name, key.words);
}

std::optional<double> read_optional(const document::Table& table, const NumberKey& key) {
  return table.optional_number(key.name, key.range);
}

void TableKeys::describe(const Key& key, const std::string& form, std::string absent, std::string doc) {
  const std::string wanted = key.range.wanted(), unit = key.range.unit();
  std::string value = form;
  if (!unit.empty() && !wanted.ends_with(unit)) value += fmt::format(" ({})", unit);
  if (!wanted.empty()) value += " " + wanted;
  description_.keys.push_back({key.name, value, std::move(absent), std::move(doc)});
}

NumberKey TableKeys::number(std::string name, document::Range range, std::string doc, std::string absent) {
  NumberKey key = {{std::move(name), std::move(range)}, std::nullopt};
  describe(key, "number", std::move(absent), std::move(doc));
  return key;
}

NumberKey TableKeys::number(std::string name, document::Range range, double fallback, std::string doc) {
  NumberKey key =
      number(std::move(name), std::move(range), std::move(doc), fmt::format("default {:g}", fallback));
  key.fallback = fallback;
  return key;
}

IntegerKey TableKeys::integer(std::string name, document::Range range, std::string doc, std::string absent) {
  IntegerKey key = {{std::move(name), std::move(range)}, std::nullopt};
  describe(key, "whole number", std::move(absent), std::move(doc));
  return key;
}

IntegerKey TableKeys::integer(std::string name, document::Range range, std::int64_t fallback,
                              std::string doc) {
  IntegerKey key =
      integer(std::move(name), std::move(range), std::move(doc), fmt::format("default {}", fallback));
  key.fallback = fallback;
  return key;
}

BooleanKey TableKeys::boolean(std::string name, bool fallback, std::string doc) {
  BooleanKey key = {{std::move(name)}, fallback};
  describe(key, "true or false", fmt::format("default {}", fallback), std::move(doc));
  return key;
}

StringKey TableKeys::string(std::string name, std::string doc, std::string absent) {
  StringKey key = {{std::move(name)}, std::nullopt};
  describe(key, "text", std::move(absent), std::move(doc));
  return key;
}

StringKey TableKeys::string(std::string name, std::string fallback, std::string doc, std::string absent) {
  StringKey key = string(std::move(name), std::move(doc), std::move(absent));
  key.fallback = std::move(fallback);
  return key;
}

ChoiceKey TableKeys::choice(std::string name, std::vector<std::string> words, std::string doc,
                            std::string absent) {
  ChoiceKey key = {{{std::move(name)}, std::nullopt}, std::move(words)};
  describe(key, fmt::format("\"{}\"", fmt::join(key.words, "\", \"")), std::move(absent), std::move(doc));
  return key;
}

ChoiceKey TableKeys::choice_or_first(std::string name, std::vector<std::string> words, std::string doc) {
  const std::string first = words.front();
  ChoiceKey key =
      choice(std::move(name), std::move(words), std::move(doc), fmt::format("default \"{}\"", first));
  key.fallback = first;
  return key;
}

Key TableKeys::other(std::string name, std::string form, document::Range range, std::string absent,
                     std::string doc) {
  Key key = {std::move(name), std::move(range)};
  describe(key, form, std::move(absent), std::move(doc));
  return key;
}

}  // namespace scree::scenario
