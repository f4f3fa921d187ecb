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
  return bare ? std::string(key) : quoted(key);
}

std::string inline_text(const DocumentState& document, const toml::table& table) {
  std::string entries;
  for (const auto& [key, value] : document.entries(table)) {
    entries +=
        fmt::format("{}{} = {}", entries.empty() ? "" : ", ", key_text(*key), value_text(document, *value));
  }
  return entries.empty() ? "{}" : fmt::format("{{ {} }}", entries);
}

std::string inline_text(const DocumentState& document, const toml::array& array) {
  std::string elements;
  for (const toml::node& element : array) {
    elements += (elements.empty() ? "" : ", ") + value_text(document, element);
  }
  return fmt::format("[{}]", elements);
}

bool has_header(const toml::node& node) { return node.is_table() && !node.as_table()->is_inline(); }

bool has_headers(const toml::node& node) {
  const toml::array* array = node.as_array();
  return array != nullptr && !array->empty() && std::all_of(array->begin(), array->end(), has_header);
}

// A table that holds nothing but tables is there by their headers.
bool needs_header(const toml::table& table) {
  return table.empty() || std::any_of(table.begin(), table.end(), [](const auto& entry) {
           return !has_header(entry.second) && !has_headers(entry.second);
         });
}

// Plain values first: behind a header they would belong to the table of that header.
void append(const DocumentState& document, const toml::table& table, const std::string& above,
            std::string& text) {
  const auto entries = document.entries(table);
  for (const auto& [key, value] : entries) {
    if (!has_header(*value) && !has_headers(*value))
      text += fmt::format("{} = {}\n", key_text(*key), value_text(document, *value));
  }
  for (const auto& [key, value] : entries) {
    const std::string path = above + key_text(*key);
    const char* gap = text.empty() ? "" : "\n";
    if (has_header(*value)) {
      if (needs_header(*value->as_table())) text += fmt::format("{}[{}]\n", gap, path);
      append(document, *value->as_table(), path + ".", text);
    } else if (has_headers(*value)) {
      for (const toml::node& entry : *value->as_array()) {
        text += fmt::format("{}[[{}]]\n", text.empty() ? "" : "\n", path);
        append(document, *entry.as_table(), path + ".", text);
      }
    }
  }
}

}  // namespace

std::string quoted(std::string_view text) {
  return fmt::format("\"{}\"", files::escaped(text, files::Escapes::toml));
}

std::string value_text(const DocumentState& document, const toml::node& node) {
  return node.visit([&](const auto& value) -> std::string {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (toml::is_table<Value> || toml::is_array<Value>) {
      return inline_text(document, value);
    } else if constexpr (toml::is_string<Value>) {
      return quoted(value.get());
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
