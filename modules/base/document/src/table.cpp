#include "tree.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/document/table.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::document {
namespace {

// Part of a message: a present key that is not yet known and is spelt similarly to the missing key.
std::string misspelt(const TableState& table, std::string_view key) {
  std::vector<std::string> unasked = table.document->keys(*table.toml);
  std::erase_if(unasked, [&](const std::string& present) { return table.knows(present); });
  const auto near = nearest_word(key, unasked);
  if (!near) return "";
  const auto at = table.toml->find(*near);
  return fmt::format(", or correct '{}' ({}) if that is meant", files::one_line(*near),
                     table.document->key_place({&at->first, &at->second}));
}

Error missing(const TableState& table, std::string_view key, std::string_view form) {
  return table.document->error(*table.toml,
                               fmt::format("{} has no '{}'", table.document->label(*table.toml), key),
                               fmt::format("add {}{}", form, misspelt(table, key)));
}

Table handle(const std::shared_ptr<TableState>& from, const toml::table& table) {
  return Table(std::shared_ptr<TableState>(from, &from->document->state_of(table)));
}

Table checked_table(const std::shared_ptr<TableState>& from, const toml::node& child, std::string_view key) {
  if (const toml::table* table = child.as_table()) return handle(from, *table);
  const DocumentState& document = *from->document;
  throw document.wrong_type(child, child.is_array_of_tables()
                                       ? fmt::format("keep one entry, written [{}]", key)
                                       : fmt::format("give a table [{}]", document.path(child)));
}

// Node at which a message is placed: the element if it exists, else the value of the key, else the table.
const toml::node& nearest_node(const TableState& table, std::string_view key, std::size_t element) {
  const toml::node* child = table.toml->get(key);
  if (child == nullptr) return *table.toml;
  const toml::array* array = child->as_array();
  return array != nullptr && element < array->size() ? (*array)[element] : *child;
}

std::size_t characters(std::string_view text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
}

struct Unknown {
  const toml::table* table = nullptr;
  DocumentState::Entry entry;
};

// Finds the first unknown key at or below a node in file order; keys written by overrides come last.
void find_unknown(DocumentState& document, const toml::node& node, Unknown& first) {
  const toml::table* table = node.as_table();
  if (table == nullptr)
    return each_child(node, [&](const toml::node& element) { find_unknown(document, element, first); });
  const TableState& state = document.state_of(*table);
  const auto order = [&](const DocumentState::Entry& entry) {
    const toml::source_position& at = entry.first->source().begin;
    return std::make_tuple(document.override_of(entry.second->source()) + 1, at.line, at.column);
  };
  for (const auto& [key, value] : *table) {
    const DocumentState::Entry entry(&key, &value);
    if (state.accepted.contains(key.str())) continue;
    if (state.knows(key.str()))
      find_unknown(document, value, first);
    else if (first.table == nullptr || order(entry) < order(first.entry))
      first = {table, entry};
  }
}

}  // namespace

bool TableState::knows(std::string_view name) const {
  return std::find(known.begin(), known.end(), name) != known.end();
}

const toml::node* TableState::ask(std::string_view name) {
  if (!knows(name)) known.emplace_back(name);
  return toml->get(name);
}

const toml::node& TableState::require(std::string_view name, std::string_view form) {
  if (const toml::node* node = ask(name)) return *node;
  throw missing(*this, name, form);
}

std::string Table::path() const { return state_->document->path(*state_->toml); }

std::string Table::label() const { return state_->document->label(*state_->toml); }

std::vector<std::string> Table::keys() const { return state_->document->keys(*state_->toml); }

Table Table::table(std::string_view key) const {
  const toml::node* child = state_->ask(key);
  if (child != nullptr) return checked_table(state_, *child, key);
  throw missing(*state_, key, fmt::format("a table [{}]", state_->document->path_below(*state_->toml, key)));
}

std::optional<Table> Table::optional_table(std::string_view key) const {
  const toml::node* child = state_->ask(key);
  return child != nullptr ? std::optional(checked_table(state_, *child, key)) : std::nullopt;
}

Table Table::table_or_empty(std::string_view key) const {
  if (const toml::node* child = state_->ask(key)) return checked_table(state_, *child, key);
  const toml::table& absent = state_->document->absent.emplace_back();
  TableState& state = state_->document->state_of(absent);
  state.above = state_.get();
  state.key = key;
  return handle(state_, absent);
}

std::vector<Table> Table::tables(std::string_view key) const {
  const toml::node* child = state_->ask(key);
  if (child == nullptr) return {};
  if (const toml::table* table = child->as_table()) return {handle(state_, *table)};
  const DocumentState& document = *state_->document;
  const auto refuse = [&](const toml::node& node) {
    return document.wrong_type(node, fmt::format("give tables [[{}]]", document.path(*child)));
  };
  if (!child->is_array()) throw refuse(*child);
  std::vector<Table> entries;
  for (const toml::node& element : *child->as_array()) {
    if (!element.is_table()) throw refuse(element);
    entries.push_back(handle(state_, *element.as_table()));
  }
  return entries;
}

void Table::accept(std::string_view key) const {
  state_->ask(key);
  state_->accepted.emplace(key);
}

bool Table::optional(std::string_view key) const { return state_->ask(key) != nullptr; }

void Table::refuse_unused() const {
  DocumentState& document = *state_->document;
  Unknown unknown;
  find_unknown(document, *state_->toml, unknown);
  if (unknown.table == nullptr) return;
  const std::vector<std::string>& known = document.state_of(*unknown.table).known;
  // An override may mean the entry of a list by its name, which it misspells.
  const std::string_view key = unknown.entry.first->str();
  std::vector<std::string> meant = known;
  if (document.override_of(unknown.entry.second->source()) < document.overrides.size())
    for (const std::string_view naming : naming_keys)
      if (const auto* name = unknown.table->get_as<std::string>(naming); name && name->get() != key)
        meant.push_back(name->get());
  const std::string cure = known.empty() ? "remove it, no key is read here" : "known keys: " + listed(known);
  throw Error(document.key_place(unknown.entry),
              fmt::format("unknown key '{}' in {}", files::one_line(key), document.label(*unknown.table)),
              suggestion(key, meant) + cure);
}

std::string Table::place() const { return state_->document->place(*state_->toml); }

std::string Table::place(std::string_view key, std::size_t element) const {
  return state_->document->place(nearest_node(*state_, key, element));
}

std::string Table::misspelt(std::string_view missing) const { return document::misspelt(*state_, missing); }

Error Table::error(std::string_view what, std::string_view cure) const {
  return state_->document->error(*state_->toml, what, cure);
}

Error Table::error(std::string_view key, std::string_view what, std::string_view cure) const {
  return error(key, whole, what, cure);
}

Error Table::error(std::string_view key, std::size_t element, std::string_view what,
                   std::string_view cure) const {
  return state_->document->error(nearest_node(*state_, key, element), what, cure);
}

Error Table::error_in_string(std::string_view key, std::size_t byte, std::string_view what,
                             std::string_view cure) const {
  const toml::node& node = *state_->toml->get(key);
  const std::string_view text = *node.value<std::string_view>();
  const std::size_t before = characters(text.substr(0, byte));
  toml::source_region source = node.source();
  const bool plain = source.path == nullptr && source.begin.line == source.end.line &&
                     source.end.column - source.begin.column == characters(text) + 2;  // with the quotes
  if (!plain)
    return state_->document->error(node, fmt::format("at character {}: {}", before + 1, what), cure);
  source.begin.column += toml::source_index(before + 1);
  return {place_text(state_->document->name, source), std::string(what), std::string(cure)};
}

}  // namespace scree::document
