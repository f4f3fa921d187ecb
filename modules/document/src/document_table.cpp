#include "document_message.hpp"
#include "document_state.hpp"

#include <fmt/format.h>

#include <scree/document/table.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::document {
namespace {

// A present key that nobody has asked for yet and that looks like the missing one.
std::string misspelt(const DocumentState& state, const Node& table, std::string_view key) {
  std::vector<std::string> unasked;
  for (const auto& child : table.children) {
    bool asked = false;
    for (const std::string& name : table.known) asked = asked || name == child->key;
    if (!asked) unasked.push_back(child->key);
  }
  const auto near = nearest_word(key, unasked);
  if (!near) return "";
  return fmt::format(", or correct '{}' ({}) if that is meant", files::one_line(*near),
                     state.key_place_text(*table.find(*near)));
}

}  // namespace

std::string Table::path() const { return node_->path(); }

std::string Table::label() const { return node_->label(); }

std::vector<std::string> Table::keys() const {
  std::vector<std::string> names;
  names.reserve(node_->children.size());
  for (const auto& child : node_->children) names.push_back(child->key);
  return names;
}

Node* Table::find(std::string_view key) const {
  node_->know(key);
  return node_->find(key);
}

Node& Table::require(std::string_view key, std::string_view form) const {
  if (Node* node = find(key)) return *node;
  throw state_->error(*node_, fmt::format("{} has no '{}'", label(), key),
                      fmt::format("add {}{}", form, misspelt(*state_, *node_, key)));
}

Table Table::checked_table(Node& child) const {
  if (child.kind == NodeKind::table) return {state_, &child};
  throw state_->error(child, fmt::format("{} is {}", child.path(), child.description()),
                      child.is_array_of_tables() ? fmt::format("keep one entry, written [{}]", child.key)
                                                 : fmt::format("give a table [{}]", child.path()));
}

Table Table::table(std::string_view key) const {
  return checked_table(require(key, fmt::format("a table [{}]", path_below(*node_, key))));
}

std::optional<Table> Table::optional_table(std::string_view key) const {
  Node* child = find(key);
  if (child == nullptr) return std::nullopt;
  return checked_table(*child);
}

Table Table::table_or_empty(std::string_view key) const {
  if (Node* child = find(key)) return checked_table(*child);
  auto empty = std::make_unique<Node>();
  empty->key = key;
  empty->place = node_->place;
  empty->origin = node_->origin;
  empty->parent = node_;
  state_->absent.push_back(std::move(empty));
  return {state_, state_->absent.back().get()};
}

std::vector<Table> Table::tables(std::string_view key) const {
  std::vector<Table> entries;
  Node* child = find(key);
  if (child == nullptr) return entries;
  if (child->kind == NodeKind::table) return {Table{state_, child}};
  if (child->kind != NodeKind::array) {
    throw state_->error(*child, fmt::format("{} is {}", child->path(), child->description()),
                        fmt::format("give tables [[{}]]", child->path()));
  }
  for (const auto& element : child->children) {
    if (element->kind != NodeKind::table) {
      throw state_->error(*element, fmt::format("{} is {}", element->path(), element->description()),
                          fmt::format("give tables [[{}]]", child->path()));
    }
    entries.emplace_back(state_, element.get());
  }
  return entries;
}

void Table::accept(std::string_view key) const {
  if (Node* child = find(key)) child->accepted = true;
}

std::string Table::place() const { return state_->place_text(*node_); }

std::string Table::place(std::string_view key) const {
  const Node* child = find(key);
  return state_->place_text(child != nullptr ? *child : *node_);
}

Error Table::error(std::string_view what, std::string_view cure) const {
  return state_->error(*node_, what, cure);
}

Error Table::error(std::string_view key, std::string_view what, std::string_view cure) const {
  const Node* child = find(key);
  return state_->error(child != nullptr ? *child : *node_, what, cure);
}

const Node& Table::at(std::string_view key, std::size_t element) const {
  const Node* child = find(key);
  if (child == nullptr) return *node_;
  const bool inside = child->kind == NodeKind::array && element < child->children.size();
  return inside ? *child->children[element] : *child;
}

std::string Table::place(std::string_view key, std::size_t element) const {
  return state_->place_text(at(key, element));
}

Error Table::error(std::string_view key, std::size_t element, std::string_view what,
                   std::string_view cure) const {
  return state_->error(at(key, element), what, cure);
}

}  // namespace scree::document
