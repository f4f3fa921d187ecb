#include "override.hpp"

#include "document_message.hpp"
#include "document_parse.hpp"
#include "override_entry.hpp"
#include "override_path.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

// The table that a name is looked up in: the node itself, or the only entry of an array of tables.
Node& table_at(Node& node, const OverrideSegment& segment, std::string_view place) {
  if (node.kind == NodeKind::table) return node;
  if (node.is_array_of_tables()) return only_entry(node, segment.name, place);
  throw Error(fmt::format("{}: {} is {}, so it has no '{}'; give {} itself a value or correct the path",
                          place, node.path(), node.description(), files::one_line(segment.name),
                          node.path()));
}

Node& child_of(Node& table, const OverrideSegment& segment, std::size_t number, std::string_view place) {
  if (Node* child = table.find(segment.name)) return *child;
  if (!segment.indices.empty()) {
    std::vector<std::string> present;
    for (const auto& child : table.children) present.push_back(child->key);
    const std::string hint = suggestion(segment.name, present);
    throw Error(fmt::format("{}: {} has no '{}' to take an entry of{} an override adds no entries to a list",
                            place, table.label(), files::one_line(segment.name), hint.empty() ? ";" : hint));
  }
  auto created = std::make_unique<Node>();
  created->key = segment.name;
  created->origin = number;
  return table.add(std::move(created));
}

Node& step_into(Node& node, const OverrideSegment& segment, std::size_t number, std::string_view place) {
  Node* next = node.is_array_of_tables() ? named_entry(node, segment.name, place) : nullptr;
  if (next == nullptr) next = &child_of(table_at(node, segment, place), segment, number, place);
  for (const std::size_t index : segment.indices) next = &entry_at(*next, index, place);
  return *next;
}

void replace(Node& target, std::unique_ptr<Node> value) {
  Node& parent = *target.parent;
  value->key = target.key;
  value->parent = &parent;
  for (auto& child : parent.children) {
    if (child.get() != &target) continue;
    child = std::move(value);
    return;
  }
}

// The first override that wrote any of this.
std::size_t first_origin(const Node& node) {
  std::size_t first = node.origin;
  for (const auto& child : node.children) first = std::min(first, first_origin(*child));
  return first;
}

}  // namespace

void apply_override(DocumentState& state, std::size_t number) {
  const std::string place = state.override_text(number);
  if (!is_toml_text(state.overrides[number]))
    throw Error(fmt::format("{}: is not UTF-8 text; encode it as UTF-8", place));
  const OverridePath path = parse_override(state.overrides[number], place);
  std::unique_ptr<Node> value = parse_override_value(path.value, number, place);
  Node* node = state.root.get();
  for (std::size_t i = 0; i + 1 < path.segments.size(); ++i) {
    node = &step_into(*node, path.segments[i], number, place);
  }
  const OverrideSegment& last = path.segments.back();
  Node* target = &child_of(table_at(*node, last, place), last, number, place);
  for (const std::size_t index : last.indices) target = &entry_at(*target, index, place);
  if (const std::size_t before = first_origin(*target); before < number && state.outdone.empty())
    state.outdone = fmt::format("{} is undone by {}", state.override_text(before), place);
  replace(*target, std::move(value));
}

}  // namespace scree::document
