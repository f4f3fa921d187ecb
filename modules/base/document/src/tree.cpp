#include "tree.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

// One step of a path: from a table or an array to a value in it.
struct Step {
  std::string_view key;
  const toml::array* row = nullptr;  // the array of the value, which then has an index and no key
  std::size_t index = 0;
};

bool find_steps(const toml::node& from, const toml::node& target, std::vector<Step>& steps) {
  if (&from == &target) return true;
  const auto reach = [&](const toml::node& child, const Step& step) {
    steps.push_back(step);
    if (find_steps(child, target, steps)) return true;
    steps.pop_back();
    return false;
  };
  if (const toml::table* table = from.as_table()) {
    for (const auto& [key, value] : *table) {
      if (reach(value, {key.str()})) return true;
    }
  } else if (const toml::array* row = from.as_array()) {
    for (std::size_t i = 0; i < row->size(); ++i) {
      if (reach((*row)[i], {"", row, i})) return true;
    }
  }
  return false;
}

// Path of a node, found by a search from the root; used only for messages.
std::vector<Step> steps_to(const DocumentState& document, const toml::node& node) {
  std::vector<Step> steps;
  const auto state = document.tables.find(&node);
  if (state != document.tables.end() && state->second.above != nullptr) {
    steps = steps_to(document, *state->second.above->toml);
    steps.push_back({state->second.key});
  } else {
    find_steps(document.root, node, steps);
  }
  return steps;
}

// Dotted path. Indices are omitted in headers, and for the only entry of an array of tables.
std::string dotted(const std::vector<Step>& steps, bool header) {
  std::string text;
  for (const Step& step : steps) {
    if (header && step.key.empty()) continue;
    if (step.row == nullptr) {
      if (!text.empty()) text += '.';
      text += files::one_line(step.key);
    } else if (step.row->size() > 1 || !(*step.row)[step.index].is_table()) {
      text += fmt::format("[{}]", step.index);
    }
  }
  return text;
}

}  // namespace

TableState& DocumentState::state_of(const toml::table& table) {
  return tables.try_emplace(&table, TableState{this, &table}).first->second;
}

std::size_t DocumentState::override_of(const toml::source_region& source) const {
  if (source.path == nullptr) return static_cast<std::size_t>(-1);
  return static_cast<std::size_t>(std::find(overrides.begin(), overrides.end(), *source.path) -
                                  overrides.begin());
}

std::vector<DocumentState::Entry> DocumentState::entries(const toml::table& table) const {
  std::vector<Entry> found;
  for (const auto& [key, value] : table) found.emplace_back(&key, &value);
  const auto order = [&](const Entry& entry) {
    const toml::source_region& source = entry.first->source();
    // The file has the largest number, which wraps to 0, so that its entries come first.
    return std::make_tuple(override_of(source) + 1, source.begin.line, source.begin.column);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Entry& a, const Entry& b) { return order(a) < order(b); });
  return found;
}

std::vector<std::string> DocumentState::keys(const toml::table& table) const {
  std::vector<std::string> names;
  for (const auto& [key, value] : entries(table)) names.emplace_back(key->str());
  return names;
}

std::string place_text(std::string_view name, const toml::source_region& region) {
  if (region.path != nullptr) return *region.path;
  const auto from_1 = [](toml::source_index index) { return std::max<toml::source_index>(index, 1); };
  return fmt::format("{}:{}:{}", name, from_1(region.begin.line), from_1(region.begin.column));
}

std::string DocumentState::place(const toml::node& node) const {
  const auto state = tables.find(&node);
  if (state != tables.end() && state->second.above != nullptr) return place(*state->second.above->toml);
  return place_text(name, node.source());
}

std::string DocumentState::key_place(const Entry& entry) const {
  const toml::source_region& value = entry.second->source();
  return place_text(name, value.path != nullptr ? value : entry.first->source());
}

std::string DocumentState::path(const toml::node& node) const { return dotted(steps_to(*this, node), false); }

std::string_view DocumentState::key_of(const toml::node& node) const {
  return steps_to(*this, node).back().key;
}

std::string DocumentState::path_below(const toml::node& table, std::string_view key) const {
  std::vector<Step> steps = steps_to(*this, table);
  steps.push_back({key});
  return dotted(steps, false);
}

std::string DocumentState::label(const toml::table& table) const {
  const std::vector<Step> steps = steps_to(*this, table);
  if (steps.empty()) return "the file";
  const std::string header = fmt::format("[{}]", dotted(steps, true));
  return steps.back().row == nullptr ? header : fmt::format("[{}]", header);
}

Error DocumentState::error(const toml::node& node, std::string_view what, std::string_view cure) const {
  return {place(node), std::string(what), std::string(cure)};
}

Error DocumentState::wrong_type(const toml::node& node, std::string_view cure) const {
  return error(node, fmt::format("{} is {}", path(node), description(*this, node)), cure);
}

}  // namespace scree::document
