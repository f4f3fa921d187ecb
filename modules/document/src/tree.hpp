#pragma once

#include <cstddef>
#include <deque>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include <scree/error.hpp>

namespace scree::document {

struct DocumentState;

// What stands behind a Table: a table of the document, and which of its keys readers have asked for.
struct TableState {
  DocumentState* document;
  const toml::table* toml;
  const TableState* above = nullptr;    // only of a table that the text has not: where it would stand,
  std::string key = {};                 // and under which key
  std::vector<std::string> known = {};  // in order of asking
  std::set<std::string, std::less<>> accepted = {};  // of these, those with nothing unknown below

  bool knows(std::string_view key) const;
  // The value under a key, which is known from now on; null when absent.
  const toml::node* ask(std::string_view key);
  // The same; throws when absent. form is what to add: "step = <number> (s)".
  const toml::node& require(std::string_view key, std::string_view form);
};

// What all handles to one document share. Nodes of the file carry line and column as their source, nodes of
// an override carry its text as the path of their source.
struct DocumentState {
  using Entry = std::pair<const toml::key*, const toml::node*>;

  std::string name;
  std::vector<std::string> overrides;  // applied so far, as "--set key=value"
  std::string conflict;                // "<override> is undone by <override>" of the first, if any
  toml::table root = {};
  std::unordered_map<const toml::node*, TableState> tables = {};  // those that were asked for
  std::deque<toml::table> absent = {};                            // those that read as empty ones

  TableState& state_of(const toml::table& table);
  // From 0; above all when a node is of the file.
  std::size_t override_of(const toml::source_region& source) const;
  // In file order; what overrides added comes behind.
  std::vector<Entry> entries(const toml::table& table) const;
  std::vector<std::string> keys(const toml::table& table) const;

  std::string place(const toml::node& node) const;
  std::string key_place(const Entry& entry) const;
  // As an override would write it: "contact[1].friction".
  std::string path(const toml::node& node) const;
  // Empty for an element of an array.
  std::string_view key_of(const toml::node& node) const;
  std::string path_below(const toml::node& table, std::string_view key) const;
  // As the file writes it: "[time]", "[[contact]]", "the file".
  std::string label(const toml::table& table) const;
  Error error(const toml::node& node, std::string_view what, std::string_view cure) const;
  // "path is kind (value)", with a cure.
  Error wrong_type(const toml::node& node, std::string_view cure) const;
};

// The values that a table or array holds.
template <class Action>
void each_child(const toml::node& node, Action&& action) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) action(value);
  } else if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) action(element);
  }
}

// "name:line:column", or the override that a region is of.
std::string place_text(std::string_view name, const toml::source_region& region);

// Kind and value for messages: a string ("2e-5").
std::string description(const DocumentState& document, const toml::node& node);

// A string as TOML writes it.
std::string quoted_text(std::string_view text);
// One value as TOML in one line.
std::string value_text(const DocumentState& document, const toml::node& node);
// All of it as TOML.
std::string document_text(const DocumentState& document);

// Throws Error "name:line:column: not valid TOML: what; cure".
toml::table parse_text(std::string_view text, std::string_view name);
// An override's value under the key "value". A text that is no TOML value is a string, unless it opens with a
// bracket, brace or quote. Throws Error "place: what is wrong; what to do".
toml::table parse_value(std::string_view text, const std::string& place);

// Writes "key=value" into the document. Throws Error "--set key=value: what is wrong; what to do".
void apply_override(DocumentState& document, std::string_view text);

}  // namespace scree::document
