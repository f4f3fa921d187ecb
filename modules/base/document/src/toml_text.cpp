#include "tree.hpp"

#include <algorithm>
#include <sstream>
#include <type_traits>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::document {
namespace {

std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(key) : quoted_text(key);
}

// Whether a value is written under its own header: [table] or [[entry]].
bool has_header(const toml::node& node) {
  if (const toml::table* table = node.as_table()) return !table->is_inline();
  const toml::array* array = node.as_array();
  return array != nullptr && !array->empty() &&
         std::all_of(array->begin(), array->end(),
                     [](const auto& entry) { return entry.is_table() && has_header(entry); });
}

// Plain values are written first: after a header they would belong to the table of that header.
void append(const DocumentState& document, const toml::table& table, const std::string& above,
            std::string& text) {
  const auto entries = document.entries(table);
  for (const auto& [key, value] : entries) {
    if (!has_header(*value)) text += fmt::format("{} = {}\n", key_text(*key), value_text(document, *value));
  }
  for (const auto& [key, value] : entries) {
    if (!has_header(*value)) continue;
    const std::string path = above + key_text(*key);
    const auto append_below = [&](const toml::node& entry, std::string_view header) {
      if (!header.empty()) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", header);
      append(document, *entry.as_table(), path + ".", text);
    };
    const toml::table* child = value->as_table();
    // A table that contains only tables needs no header: their headers imply it.
    const bool plain = child != nullptr &&
                       (child->empty() || std::any_of(child->begin(), child->end(),
                                                      [](const auto& e) { return !has_header(e.second); }));
    if (child != nullptr)
      append_below(*child, plain ? fmt::format("[{}]", path) : "");
    else
      each_child(*value, [&](const toml::node& entry) { append_below(entry, fmt::format("[[{}]]", path)); });
  }
}

}  // namespace

std::string quoted_text(std::string_view text) {
  return fmt::format("\"{}\"", files::escaped(text, files::Escapes::toml));
}

std::string value_text(const DocumentState& document, const toml::node& node) {
  return node.visit([&](const auto& value) -> std::string {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (toml::is_table<Value>) {
      std::vector<std::string> entries;
      for (const auto& [key, entry] : document.entries(value))
        entries.push_back(fmt::format("{} = {}", key_text(*key), value_text(document, *entry)));
      return entries.empty() ? "{}" : fmt::format("{{ {} }}", listed(entries));
    } else if constexpr (toml::is_array<Value>) {
      std::vector<std::string> elements;
      for (const toml::node& element : value) elements.push_back(value_text(document, element));
      return fmt::format("[{}]", listed(elements));
    } else if constexpr (toml::is_string<Value>) {
      return quoted_text(value.get());
    } else if constexpr (toml::is_floating_point<Value>) {
      return toml_number_text(value.get());
    } else {
      std::ostringstream text;  // integers, booleans, dates and times
      text << std::boolalpha << value.get();
      return text.str();
    }
  });
}

std::string document_text(const DocumentState& document) {
  std::string text;
  append(document, document.root, "", text);
  return text;
}

std::string description(const DocumentState& document, const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return node.is_array_of_tables() ? "an array of tables" : "an array";
  if (const auto* text = node.as_string())
    return fmt::format("a string (\"{}\")", files::one_line(text->get()));
  const char* kind = node.is_integer()          ? "an integer"
                     : node.is_floating_point() ? "a floating-point number"
                     : node.is_boolean()        ? "a boolean"
                                                : "a date or time";
  return fmt::format("{} ({})", kind, value_text(document, node));
}

}  // namespace scree::document
