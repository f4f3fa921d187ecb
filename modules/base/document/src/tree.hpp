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

// Keys by whose value an override names an entry of a list of tables; the first key that fits counts.
inline constexpr std::string_view naming_keys[] = {"name", "plugin", "type"};

// What a handle Table refers to: a table of the document, and the keys that readers have requested from it.
struct TableState {
  DocumentState* document;
  const toml::table* toml;
  const TableState* above = nullptr;    // only for a table absent from the text: its parent table,
  std::string key = {};                 // and its key in the parent
  std::vector<std::string> known = {};  // requested keys, in the order of their first request
  std::set<std::string, std::less<>> accepted = {};  // known keys below which every key is allowed

  bool knows(std::string_view key) const;
  // Marks a key as known and returns its value; null if the key is absent.
  const toml::node* ask(std::string_view key);
  // The same, but throws Error if the key is absent. form: the text to add, "step = <number> (s)".
  const toml::node& require(std::string_view key, std::string_view form);
};

// State of a document, shared by all handles to it. The source of a node of the file is its line and column;
// the source of a node of an override has the text of the override as its path.
struct DocumentState {
  using Entry = std::pair<const toml::key*, const toml::node*>;

  std::string name;
  std::vector<std::string> overrides;  // applied so far, as "--set key=value"
  std::string conflict;                // the first "<override> is undone by <override>", or empty
  toml::table root = {};
  std::unordered_map<const toml::node*, TableState> tables = {};  // tables accessed so far
  std::deque<toml::table> absent = {};                            // absent tables that are read as empty

  TableState& state_of(const toml::table& table);
  // Index of the override that wrote a node, from 0; the largest std::size_t if the node is of the file.
  std::size_t override_of(const toml::source_region& source) const;
  // In file order, followed by the entries that overrides have added.
  std::vector<Entry> entries(const toml::table& table) const;
  std::vector<std::string> keys(const toml::table& table) const;

  std::string place(const toml::node& node) const;
  std::string key_place(const Entry& entry) const;
  // Path in the notation of overrides: "contact[1].friction".
  std::string path(const toml::node& node) const;
  // Key of a node; empty for an element of an array.
  std::string_view key_of(const toml::node& node) const;
  std::string path_below(const toml::node& table, std::string_view key) const;
  // Name in the notation of the file: "[time]", "[[contact]]"; "the file" for the root.
  std::string label(const toml::table& table) const;
  Error error(const toml::node& node, std::string_view what, std::string_view cure) const;
  // Error "place: path is kind (value); cure".
  Error wrong_type(const toml::node& node, std::string_view cure) const;
};

// Calls action(value) for each value of a table or element of an array.
template <class Action>
void each_child(const toml::node& node, Action&& action) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) action(value);
  } else if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) action(element);
  }
}

// "name:line:column", or the text of the override that wrote the region.
std::string place_text(std::string_view name, const toml::source_region& region);

// Kind and value of a node for messages: a string ("2e-5").
std::string description(const DocumentState& document, const toml::node& node);

// A string in TOML notation, in double quotes.
std::string quoted_text(std::string_view text);
// A value as TOML on one line.
std::string value_text(const DocumentState& document, const toml::node& node);
// The whole document as TOML.
std::string document_text(const DocumentState& document);

// Parses the text of a file. Throws Error "name:line:column: not valid TOML: what; cure".
toml::table parse_text(std::string_view text, std::string_view name);
// Parses the value of an override and returns it under the key "value". Text that is not a TOML value is read
// as a string, unless it begins with a bracket, a brace or a quote.
// Throws Error "place: what is wrong; what to do".
toml::table parse_value(std::string_view text, const std::string& place);

// Applies the override "key=value" to the document.
// Throws Error "--set key=value: what is wrong; what to do".
void apply_override(DocumentState& document, std::string_view text);

}  // namespace scree::document
