#include "document_message.hpp"
#include "document_read.hpp"
#include "document_text.hpp"

#include <fmt/format.h>

#include <scree/document/table.hpp>

namespace scree::document {
namespace {

std::string form(std::string_view key, std::string_view value, const Range& range = Range::any()) {
  const std::string unit = range.unit().empty() ? "" : fmt::format(" ({})", range.unit());
  return fmt::format("{} = {}{}", key, value, unit);
}

std::string row_form(std::size_t count) {
  std::string row;
  for (std::size_t i = 0; i < count; ++i) row += i == 0 ? "<number>" : ", <number>";
  return fmt::format("[{}]", row);
}

}  // namespace

bool Table::has(std::string_view key) const { return find(key) != nullptr; }

bool Table::is_table(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->kind == NodeKind::table;
}

bool Table::is_array(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->kind == NodeKind::array;
}

bool Table::is_number(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->is_number();
}

bool Table::is_string(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->kind == NodeKind::string;
}

bool Table::is_boolean(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->kind == NodeKind::boolean;
}

bool Table::is_inline_table(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr && node->kind == NodeKind::table && node->inline_table;
}

double Table::number(std::string_view key, const Range& range) const {
  return read_number(*state_, require(key, form(key, "<number>", range)), range);
}

double Table::number(std::string_view key, double fallback, const Range& range) const {
  return optional_number(key, range).value_or(fallback);
}

std::optional<double> Table::optional_number(std::string_view key, const Range& range) const {
  const Node* node = find(key);
  return node != nullptr ? std::optional(read_number(*state_, *node, range)) : std::nullopt;
}

std::int64_t Table::integer(std::string_view key, const Range& range) const {
  return read_integer(*state_, require(key, form(key, "<whole number>", range)), range);
}

std::int64_t Table::integer(std::string_view key, std::int64_t fallback, const Range& range) const {
  return optional_integer(key, range).value_or(fallback);
}

std::optional<std::int64_t> Table::optional_integer(std::string_view key, const Range& range) const {
  const Node* node = find(key);
  return node != nullptr ? std::optional(read_integer(*state_, *node, range)) : std::nullopt;
}

bool Table::boolean(std::string_view key) const {
  return read_boolean(*state_, require(key, form(key, "<true or false>")));
}

bool Table::boolean(std::string_view key, bool fallback) const {
  const Node* node = find(key);
  return node != nullptr ? read_boolean(*state_, *node) : fallback;
}

std::string Table::string(std::string_view key) const {
  return read_string(*state_, require(key, form(key, "\"<text>\"")));
}

std::string Table::string(std::string_view key, std::string_view fallback) const {
  const Node* node = find(key);
  return node != nullptr ? read_string(*state_, *node) : std::string(fallback);
}

std::optional<std::string> Table::optional_string(std::string_view key) const {
  const Node* node = find(key);
  return node != nullptr ? std::optional(read_string(*state_, *node)) : std::nullopt;
}

std::string Table::choice(std::string_view key, const std::vector<std::string>& allowed) const {
  return read_choice(*state_, require(key, form(key, any_of(allowed, "\""))), allowed);
}

std::string Table::choice(std::string_view key, const std::vector<std::string>& allowed,
                          std::string_view fallback) const {
  const Node* node = find(key);
  return node != nullptr ? read_choice(*state_, *node, allowed) : std::string(fallback);
}

std::vector<double> Table::numbers(std::string_view key, const Range& range) const {
  return read_numbers(*state_, require(key, form(key, "[<number>, ...]", range)), std::nullopt, range);
}

std::vector<double> Table::numbers(std::string_view key, std::size_t count, const Range& range) const {
  return read_numbers(*state_, require(key, form(key, row_form(count), range)), count, range);
}

std::vector<double> Table::numbers_or(std::string_view key, std::vector<double> fallback,
                                      const Range& range) const {
  const Node* node = find(key);
  return node != nullptr ? read_numbers(*state_, *node, fallback.size(), range) : fallback;
}

std::vector<std::vector<double>> Table::rows(std::string_view key, std::size_t columns,
                                             const Range& range) const {
  const std::string value = fmt::format("[{}, ...]", row_form(columns));
  return read_rows(*state_, require(key, form(key, value, range)), columns, range);
}

std::vector<std::string> Table::strings(std::string_view key) const {
  return read_strings(*state_, require(key, form(key, "[\"<text>\", ...]")));
}

std::vector<std::int64_t> Table::integers(std::string_view key, const Range& range) const {
  return read_integers(*state_, require(key, form(key, "[<whole number>, ...]", range)), range);
}

std::string Table::toml(std::string_view key) const {
  Node& node = require(key, form(key, "<value>"));
  node.accepted = true;
  return value_text(node);
}

std::vector<std::string> Table::toml_elements(std::string_view key) const {
  Node& node = require(key, form(key, "[<value>, ...]"));
  check_array(*state_, node, std::nullopt, "values");
  node.accepted = true;
  std::vector<std::string> values;
  values.reserve(node.children.size());
  for (const auto& element : node.children) values.push_back(value_text(*element));
  return values;
}

}  // namespace scree::document
