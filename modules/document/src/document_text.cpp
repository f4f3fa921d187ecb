#include "document_text.hpp"

#include "document_message.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace scree::document {
namespace {

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\u{:04X}", code);
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(key) : quoted_text(key);
}

std::string inline_table_text(const Node& table) {
  std::string entries;
  for (const auto& child : table.children) {
    entries +=
        fmt::format("{}{} = {}", entries.empty() ? "" : ", ", key_text(child->key), value_text(*child));
  }
  return entries.empty() ? "{}" : fmt::format("{{ {} }}", entries);
}

std::string array_text(const Node& array) {
  std::string elements;
  for (const auto& child : array.children) {
    if (!elements.empty()) elements += ", ";
    elements += value_text(*child);
  }
  return fmt::format("[{}]", elements);
}

}  // namespace

std::string value_text(const Node& node) {
  switch (node.kind) {
    case NodeKind::table:
      return inline_table_text(node);
    case NodeKind::array:
      return array_text(node);
    case NodeKind::string:
      return quoted_text(node.text);
    case NodeKind::integer:
      return std::to_string(node.integer);
    case NodeKind::number:
      return toml_number_text(node.number);
    case NodeKind::boolean:
      return node.boolean ? "true" : "false";
    case NodeKind::moment:
      return node.text;
  }
  return "";
}

namespace {

bool has_header(const Node& node) { return node.kind == NodeKind::table && !node.inline_table; }

bool has_headers(const Node& node) {
  return node.kind == NodeKind::array && !node.children.empty() &&
         std::all_of(node.children.begin(), node.children.end(),
                     [](const auto& c) { return has_header(*c); });
}

// A table that holds nothing but tables is there by their headers.
bool needs_header(const Node& table) {
  return table.children.empty() ||
         std::any_of(table.children.begin(), table.children.end(),
                     [](const auto& c) { return !has_header(*c) && !has_headers(*c); });
}

// Plain values first: behind a header they would belong to the table of that header.
void append_table(const Node& table, const std::string& above, std::string& text) {
  for (const auto& child : table.children) {
    if (!has_header(*child) && !has_headers(*child)) {
      text += fmt::format("{} = {}\n", key_text(child->key), value_text(*child));
    }
  }
  for (const auto& child : table.children) {
    const std::string path = above + key_text(child->key);
    if (has_header(*child)) {
      if (needs_header(*child)) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", path);
      append_table(*child, path + ".", text);
    } else if (has_headers(*child)) {
      for (const auto& entry : child->children) {
        text += fmt::format("{}[[{}]]\n", text.empty() ? "" : "\n", path);
        append_table(*entry, path + ".", text);
      }
    }
  }
}

}  // namespace

std::string toml_text(const Node& root) {
  std::string text;
  append_table(root, "", text);
  return text;
}

}  // namespace scree::document
