#include "document_node.hpp"

#include "document_message.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

// Names from the root down, without indices.
std::string header(const Node& node) {
  if (node.parent == nullptr) return "";
  const std::string above = header(*node.parent);
  if (node.key.empty()) return above;
  return above.empty() ? files::one_line(node.key) : above + "." + files::one_line(node.key);
}

std::string index_text(const Node& element) {
  const auto& row = element.parent->children;
  if (row.size() == 1 && element.kind == NodeKind::table) return "";
  const auto at =
      std::find_if(row.begin(), row.end(), [&](const auto& child) { return child.get() == &element; });
  return fmt::format("[{}]", at - row.begin());
}

}  // namespace

bool Node::is_array_of_tables() const {
  return kind == NodeKind::array && !children.empty() &&
         std::all_of(children.begin(), children.end(),
                     [](const auto& c) { return c->kind == NodeKind::table; });
}

Node* Node::find(std::string_view name) const {
  if (kind != NodeKind::table) return nullptr;
  const auto at =
      std::find_if(children.begin(), children.end(), [&](const auto& c) { return c->key == name; });
  return at == children.end() ? nullptr : at->get();
}

Node& Node::add(std::unique_ptr<Node> child) {
  child->parent = this;
  children.push_back(std::move(child));
  return *children.back();
}

void Node::know(std::string_view name) {
  if (std::find(known.begin(), known.end(), name) == known.end()) known.emplace_back(name);
}

std::string Node::path() const {
  if (parent == nullptr) return "";
  if (parent->kind == NodeKind::array) return parent->path() + index_text(*this);
  return path_below(*parent, key);
}

std::string Node::label() const {
  if (parent == nullptr) return "the file";
  if (parent->kind == NodeKind::array) return fmt::format("[[{}]]", header(*this));
  return fmt::format("[{}]", header(*this));
}

std::string Node::description() const {
  switch (kind) {
    case NodeKind::table:
      return "a table";
    case NodeKind::array:
      return is_array_of_tables() ? "an array of tables" : "an array";
    case NodeKind::string:
      return fmt::format("a string (\"{}\")", files::one_line(text));
    case NodeKind::integer:
      return fmt::format("an integer ({})", integer);
    case NodeKind::number:
      return fmt::format("a floating-point number ({})", toml_number_text(number));
    case NodeKind::boolean:
      return fmt::format("a boolean ({})", boolean);
    case NodeKind::moment:
      return fmt::format("a date or time ({})", text);
  }
  return "";
}

std::string path_below(const Node& table, std::string_view key) {
  const std::string above = table.path();
  return above.empty() ? files::one_line(key) : above + "." + files::one_line(key);
}

}  // namespace scree::document
