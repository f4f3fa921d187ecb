#include "document_message.hpp"
#include "document_state.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include <scree/document/table.hpp>
#include <scree/files/text.hpp>

namespace scree::document {
namespace {

// In file order, with what overrides wrote behind.
bool stands_before(const Node& a, const Node& b) {
  const auto order = [](const Node& node) {
    return std::make_tuple(node.origin != Node::in_file, node.origin, node.key_place);
  };
  return order(a) < order(b);
}

const Node* first_unknown(const Node& node) {
  if (node.accepted) return nullptr;
  const Node* first = nullptr;
  for (const auto& child : node.children) {
    const bool unknown = node.kind == NodeKind::table &&
                         std::find(node.known.begin(), node.known.end(), child->key) == node.known.end();
    const Node* found = unknown ? child.get() : first_unknown(*child);
    if (found != nullptr && (first == nullptr || stands_before(*found, *first))) first = found;
  }
  return first;
}

}  // namespace

void Table::refuse_unused() const {
  const Node* unknown = first_unknown(*node_);
  if (unknown == nullptr) return;
  const Node& table = *unknown->parent;
  const std::string key = files::one_line(unknown->key);
  const std::string hint = suggestion(unknown->key, table.known);
  const std::string cure =
      table.known.empty() ? "remove it, no key is read here" : "known keys: " + listed(table.known);
  throw Error(fmt::format("{}: unknown key '{}' in {}{} {}", state_->key_place_text(*unknown), key,
                          table.label(), hint.empty() ? ";" : hint, cure));
}

}  // namespace scree::document
