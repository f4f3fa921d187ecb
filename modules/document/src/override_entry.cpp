#include "override_entry.hpp"

#include "document_message.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>

namespace scree::document {
namespace {

constexpr std::string_view naming_keys[] = {"name", "plugin", "type"};

const std::string* text_under(const Node& entry, std::string_view key) {
  const Node* child = entry.find(key);
  return child != nullptr && child->kind == NodeKind::string ? &child->text : nullptr;
}

std::vector<std::string> names(const Node& array) {
  std::vector<std::string> found;
  for (const std::string_view key : naming_keys) {
    for (const auto& entry : array.children) {
      if (const std::string* text = text_under(*entry, key)) found.push_back(*text);
    }
  }
  return found;
}

std::string titled(const Node& entry) {
  for (const std::string_view key : naming_keys) {
    if (const std::string* text = text_under(entry, key))
      return fmt::format("{} ({})", entry.path(), files::one_line(*text));
  }
  return entry.path();
}

std::string entry_list(const std::vector<Node*>& entries) {
  std::vector<std::string> titles;
  for (const Node* entry : entries) titles.push_back(titled(*entry));
  return listed(titles);
}

std::vector<Node*> all_entries(const Node& array) {
  std::vector<Node*> entries;
  for (const auto& entry : array.children) entries.push_back(entry.get());
  return entries;
}

}  // namespace

Node* named_entry(const Node& array, std::string_view name, std::string_view place) {
  for (const std::string_view key : naming_keys) {
    std::vector<Node*> matches;
    for (const auto& entry : array.children) {
      const std::string* text = text_under(*entry, key);
      if (text != nullptr && *text == name) matches.push_back(entry.get());
    }
    if (matches.size() == 1) return matches.front();
    if (matches.empty()) continue;
    throw Error(fmt::format("{}: {} entries of {} have {} '{}'; choose one by index: {}", place,
                            matches.size(), array.path(), key, files::one_line(name), entry_list(matches)));
  }
  return nullptr;
}

Node& only_entry(const Node& array, std::string_view key, std::string_view place) {
  if (array.children.size() == 1) return *array.children.front();
  const std::string hint = suggestion(key, names(array));
  throw Error(fmt::format("{}: {} has {} entries and '{}' names none of them{} choose one: {}", place,
                          array.path(), array.children.size(), files::one_line(key),
                          hint.empty() ? ";" : hint, entry_list(all_entries(array))));
}

Node& entry_at(Node& node, std::size_t index, std::string_view place) {
  if (node.kind == NodeKind::table && index == 0) return node;
  if (node.kind != NodeKind::array) {
    throw Error(fmt::format("{}: {} is {}, so it has no entry {}; leave the index out", place, node.path(),
                            node.description(), index));
  }
  if (index < node.children.size()) return *node.children[index];
  const std::string entries = node.is_array_of_tables() ? ": " + entry_list(all_entries(node)) : "";
  throw Error(fmt::format("{}: {} has {} entries, so there is no entry {}; count from 0{}", place,
                          node.path(), node.children.size(), index, entries));
}

}  // namespace scree::document
