#include "tree.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::document {
namespace {

constexpr std::size_t nowhere = std::string_view::npos;
constexpr std::size_t most_segments = 64;
constexpr std::size_t longest_shown = 160;

// One part of a dotted path: stage[1] has the name "stage" and one index.
struct Segment {
  std::string name;
  std::vector<std::size_t> indices;  // from 0
};

// A value and its owner: a table, which has it under the key, or an array, which has it at the index.
struct Slot {
  toml::node* owner;
  std::string key;
  std::size_t index;
  toml::node* value;  // null if the table has no such key
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == nowhere) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// Position of the first `wanted` character outside quotes.
std::size_t find_unquoted(std::string_view text, char wanted) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote == 0 && text[i] == wanted) return i;
    const bool opens = quote == 0 && (text[i] == '"' || text[i] == '\'');
    if (opens || text[i] == quote) quote = opens ? text[i] : '\0';
  }
  return nowhere;
}

const std::string* text_under(const toml::node& entry, std::string_view key) {
  const auto* text = entry.as_table()->get_as<std::string>(key);
  return text != nullptr ? &text->get() : nullptr;
}

bool names(const toml::node& entry, std::string_view key, std::string_view name) {
  const std::string* text = text_under(entry, key);
  return text != nullptr && *text == name;
}

// Applies one override "key=value". Errors begin with the override, and list entries of arrays with their
// indices.
class Override {
 public:
  Override(DocumentState& document, std::string_view text)
      : document_(document), place_("--set " + files::one_line(text, longest_shown)), text_(text) {}

  void apply() {
    document_.overrides.push_back(place_);
    check_utf8();
    const std::size_t equals = find_unquoted(text_, '=');
    if (equals == nowhere) throw error("has no '='", "write --set key=value");
    const std::string_view value = trimmed(text_.substr(equals + 1));
    if (value.empty()) throw error("has no value", "write --set key='\"\"' for an empty text");
    const std::vector<Segment> path = read_path(text_.substr(0, equals));
    toml::table parsed = parse_value(value, place_);
    toml::node& given = *parsed.get("value");
    replaces_entries_ = given.is_table();
    Slot slot{nullptr, {}, 0, &document_.root};
    for (std::size_t i = 0; i < path.size(); ++i) slot = enter(*slot.value, path[i], i + 1 == path.size());
    if (slot.owner->is_array() && slot.value != nullptr && slot.value->is_table() && !given.is_table())
      throw error(fmt::format("{} is a table", document_.path(*slot.value)),
                  fmt::format("set a key of it, as in {}.key", trimmed(text_.substr(0, equals))));
    assign(slot, std::move(given));
  }

 private:
  Error error(const std::string& problem, const std::string& cure) const { return {place_, problem, cure}; }

  Error malformed(const std::string& problem) const {
    return error(problem, "write the key as in table.key, table[0].key or table.\"odd name\".key");
  }

  void check_utf8() const {
    try {
      [[maybe_unused]] const toml::table text = toml::parse("text = " + quoted_text(text_));
    } catch (const toml::parse_error&) {
      throw error("is not UTF-8 text", "encode it as UTF-8");
    }
  }

  std::vector<Segment> read_path(std::string_view text) const {
    std::vector<Segment> path;
    for (;;) {
      const std::size_t dot = find_unquoted(text, '.');
      if (path.size() == most_segments) throw malformed("the key has too many parts");
      path.push_back(read_segment(text.substr(0, dot)));
      if (dot == nowhere) return path;
      text.remove_prefix(dot + 1);
    }
  }

  Segment read_segment(std::string_view text) const {
    const std::size_t bracket = find_unquoted(text, '[');
    std::string_view name = trimmed(text.substr(0, bracket));
    if (name.empty()) throw malformed("a part of the key is empty");
    if (name.front() == '"' || name.front() == '\'') {
      if (name.size() < 2 || name.back() != name.front()) throw malformed("a quote in the key is not closed");
      name = name.substr(1, name.size() - 2);
    }
    Segment segment{std::string(name), {}};
    std::string_view rest = bracket == nowhere ? "" : trimmed(text.substr(bracket));
    while (!rest.empty()) {
      const std::size_t close = rest.find(']');
      if (rest.front() != '[' || close == nowhere) throw malformed("a bracket in the key is not closed");
      const std::string_view digits = trimmed(rest.substr(1, close - 1));
      const auto [end, failure] =
          std::from_chars(digits.data(), digits.data() + digits.size(), segment.indices.emplace_back());
      if (failure != std::errc() || end != digits.data() + digits.size())
        throw malformed(fmt::format("'{}' is no index from 0", files::one_line(digits)));
      rest = trimmed(rest.substr(close + 1));
    }
    return segment;
  }

  // Follows one segment of the path, from a table or from an array of tables. In an array the segment is the
  // name of an entry, which a value may replace as a whole, or a key of its only entry, which a table alone
  // replaces.
  Slot enter(toml::node& from, const Segment& segment, bool last) {
    Slot slot{nullptr, {}, 0, nullptr};
    const bool is_key = from.is_array_of_tables() && last && from.as_array()->size() == 1 &&
                        (!replaces_entries_ || (*from.as_array())[0].as_table()->contains(segment.name));
    if (from.is_array_of_tables() && !is_key) {
      toml::array& array = *from.as_array();
      slot = {&array, {}, 0, named_entry(array, segment.name)};
      while (slot.value != nullptr && &array[slot.index] != slot.value) ++slot.index;
    }
    if (slot.value == nullptr) slot = child_of(table_at(from, segment.name), segment, last);
    for (std::size_t k = 0; k < segment.indices.size(); ++k)
      slot = entry_at(slot, segment.indices[k], k == 0);
    return slot;
  }

  // The entry with this name or, if there is none, with this plugin or this type; null if no entry matches.
  toml::node* named_entry(toml::array& array, const std::string& name) const {
    for (const std::string_view key : naming_keys) {
      std::size_t count = 0;
      toml::node* match = nullptr;
      for (toml::node& entry : array) {
        if (!names(entry, key, name)) continue;
        match = &entry;
        ++count;
      }
      if (count == 1) return match;
      if (count > 1)
        throw error(fmt::format("{} entries of {} have {} '{}'", count, document_.path(array), key,
                                files::one_line(name)),
                    "choose one by index: " + titles(array, key, name));
    }
    return nullptr;
  }

  // The table in which a name is looked up: the node itself, or the only entry of an array of tables.
  toml::table& table_at(toml::node& node, const std::string& name) const {
    if (node.is_table()) return *node.as_table();
    const std::string path = document_.path(node);
    if (!node.is_array_of_tables())
      throw error(fmt::format("{} is {}, so it has no '{}'", path, description(document_, node),
                              files::one_line(name)),
                  fmt::format("give {} itself a value or correct the path", path));
    toml::array& array = *node.as_array();
    if (array.size() == 1) return *array[0].as_table();
    std::vector<std::string> known;
    for (const std::string_view key : naming_keys)
      for (const toml::node& entry : array)
        if (const std::string* text = text_under(entry, key)) known.push_back(*text);
    throw error(fmt::format("{} has {} and '{}' names none of them", path,
                            counted(array.size(), "entry", "entries"), files::one_line(name)),
                suggestion(name, known) + "choose one: " + titles(array));
  }

  // Creates a table for an absent key, unless it is the last of the path, to which the value is assigned.
  Slot child_of(toml::table& table, const Segment& segment, bool last) {
    toml::node* child = table.get(segment.name);
    if (child == nullptr && !segment.indices.empty())
      throw error(fmt::format("{} has no '{}' to take an entry of", document_.label(table),
                              files::one_line(segment.name)),
                  suggestion(segment.name, document_.keys(table)) + "an override adds no entries to a list");
    if (child == nullptr && !last) {
      toml::table parsed = toml::parse("[value]", place_);
      assign({&table, segment.name, 0, nullptr}, std::move(*parsed.get("value")));
      child = table.get(segment.name);
    }
    return {&table, segment.name, 0, child};
  }

  // The first index 0 of a table denotes the table itself.
  Slot entry_at(const Slot& slot, std::size_t index, bool first) const {
    toml::array* array = slot.value->as_array();
    if (slot.value->is_table() && index == 0 && first) return slot;
    const std::string path = document_.path(*slot.value);
    if (array == nullptr)
      throw error(
          fmt::format("{} is {}, so it has no entry {}", path, description(document_, *slot.value), index),
          "leave the index out");
    if (index < array->size()) return {array, {}, index, &(*array)[index]};
    throw error(fmt::format("{} has {}, so there is no entry {}", path,
                            counted(array->size(), "entry", "entries"), index),
                array->is_array_of_tables() ? "count from 0: " + titles(*array) : "count from 0");
  }

  void assign(const Slot& slot, toml::node&& value) {
    if (slot.value != nullptr && document_.conflict.empty()) {
      const std::size_t before = first_override(*slot.value);
      if (before < document_.overrides.size() - 1)
        document_.conflict = fmt::format("{} is undone by {}", document_.overrides[before], place_);
    }
    if (toml::table* table = slot.owner->as_table())
      table->insert_or_assign(toml::key(slot.key, value.source()), std::move(value));
    else
      slot.owner->as_array()->replace(slot.owner->as_array()->cbegin() + std::ptrdiff_t(slot.index),
                                      std::move(value));
  }

  // Index of the first override that wrote the node or any part of it.
  std::size_t first_override(const toml::node& node) const {
    std::size_t first = document_.override_of(node.source());
    each_child(node, [&](const toml::node& child) { first = std::min(first, first_override(child)); });
    return first;
  }

  // "stage[0] (settle), stage[1] (cycle)"; with a key, only the entries whose value of the key is `name`.
  std::string titles(const toml::array& array, std::string_view key = "", std::string_view name = "") const {
    std::vector<std::string> titles;
    for (const toml::node& entry : array) {
      if (!key.empty() && !names(entry, key, name)) continue;
      titles.push_back(document_.path(entry));
      const auto named = std::find_if(std::begin(naming_keys), std::end(naming_keys),
                                      [&](std::string_view k) { return text_under(entry, k) != nullptr; });
      if (named != std::end(naming_keys))
        titles.back() += fmt::format(" ({})", files::one_line(*text_under(entry, *named)));
    }
    return listed(titles);
  }

  DocumentState& document_;
  std::string place_;
  std::string_view text_;
  bool replaces_entries_ = false;  // the value is a table
};

}  // namespace

void apply_override(DocumentState& document, std::string_view text) { Override(document, text).apply(); }

}  // namespace scree::document
