#include "tree.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/document/table.hpp>
#include <scree/files/text.hpp>

namespace scree::document {
namespace {

std::string unit_behind(const char* text, const Range& range) {
  return range.unit().empty() ? "" : text + range.unit();
}

Error out_of_range(const DocumentState& document, const toml::node& node, const std::string& shown,
                   double value, const Range& range) {
  const std::string_view key = document.key_of(node);
  return document.error(
      node,
      fmt::format("{} = {}{} {}", document.path(node), shown, unit_behind(" ", range), range.fault(value)),
      fmt::format("give {} {}", key.empty() ? "numbers" : with_article(key), range.wanted()));
}

// The most common mistake is a number in quotes; the cure then repeats the number.
std::string number_cure(const toml::node& node, const Range& range) {
  const std::string cure = "give a number" + unit_behind(" in ", range);
  const auto* quoted_number = node.as_string();
  if (quoted_number == nullptr || quoted_number->get().empty()) return cure;
  const std::string& text = quoted_number->get();
  double value = 0;
  const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = failure == std::errc() && stop == text.data() + text.size();
  return whole && std::isfinite(value) ? cure + ", such as " + number_text(value) : cure;
}

double read_number(const DocumentState& document, const toml::node& node, const Range& range) {
  if (!node.is_number()) throw document.wrong_type(node, number_cure(node, range));
  const auto* whole = node.as_integer();
  const double value = whole ? static_cast<double>(whole->get()) : node.as_floating_point()->get();
  if (!std::isfinite(value)) {
    throw document.error(node,
                         fmt::format("{} = {} is not finite", document.path(node), toml_number_text(value)),
                         number_cure(node, range));
  }
  if (!range.contains(value)) throw out_of_range(document, node, number_text(value), value, range);
  return value;
}

std::int64_t read_integer(const DocumentState& document, const toml::node& node, const Range& range) {
  if (!node.is_integer()) {
    const double number = node.is_floating_point() ? node.as_floating_point()->get() : 0.5;
    const bool whole = std::abs(number) < 1e15 && std::trunc(number) == number;
    throw document.wrong_type(node, "give a whole number without a decimal point or exponent" +
                                        (whole ? fmt::format(", such as {:.0f}", number) : ""));
  }
  const std::int64_t value = node.as_integer()->get();
  if (!range.contains(static_cast<double>(value)))
    throw out_of_range(document, node, std::to_string(value), static_cast<double>(value), range);
  return value;
}

bool read_boolean(const DocumentState& document, const toml::node& node) {
  if (!node.is_boolean()) throw document.wrong_type(node, "give true or false");
  return node.as_boolean()->get();
}

std::string read_string(const DocumentState& document, const toml::node& node) {
  if (!node.is_string()) throw document.wrong_type(node, "give a string in quotes");
  return node.as_string()->get();
}

using Words = std::vector<std::string>;

std::string read_choice(const DocumentState& document, const toml::node& node, const Words& allowed) {
  if (!node.is_string()) throw document.wrong_type(node, "give " + any_of(allowed));
  const std::string& text = node.as_string()->get();
  for (const std::string& word : allowed) {
    if (word == text) return word;
  }
  throw document.error(
      node, fmt::format("{} = \"{}\" is none of the choices", document.path(node), files::one_line(text)),
      suggestion(text, allowed) + "give " + any_of(allowed));
}

// Reads each element of an array by read(document, element, arguments...). what: the elements in messages.
template <class Read, class... Arguments>
auto read_array(const DocumentState& document, const toml::node& node, std::optional<std::size_t> count,
                const std::string& what, Read read, const Arguments&... arguments) {
  const std::string cure =
      count ? fmt::format("give an array of {} {}", *count, what) : "give an array of " + what;
  const toml::array* array = node.as_array();
  if (array == nullptr) throw document.wrong_type(node, cure);
  if (count && array->size() != *count) {
    throw document.error(
        node, fmt::format("{} has {}", document.path(node), counted(array->size(), "element")), cure);
  }
  std::vector<decltype(read(document, node, arguments...))> values;
  values.reserve(array->size());
  for (const toml::node& element : *array) values.push_back(read(document, element, arguments...));
  return values;
}

std::variant<double, Table> read_number_or_table(const std::shared_ptr<TableState>& from,
                                                 const toml::node& node) {
  if (const toml::table* table = node.as_table())
    return Table(std::shared_ptr<TableState>(from, &from->document->state_of(*table)));
  return read_number(*from->document, node, Range::any());
}

std::vector<double> read_numbers(const DocumentState& document, const toml::node& node,
                                 std::optional<std::size_t> count, const Range& range) {
  return read_array(document, node, count, "numbers" + unit_behind(" in ", range), read_number, range);
}

// Text to add for a missing key: "step = <number> (s)".
std::string form(std::string_view key, std::string_view value, const Range& range = Range::any()) {
  return fmt::format("{} = {}{}", key, value, range.unit().empty() ? "" : " (" + range.unit() + ")");
}

std::string row_form(std::size_t count) {
  std::string row;
  for (std::size_t i = 0; i < count; ++i) row += i == 0 ? "<number>" : ", <number>";
  return fmt::format("[{}]", row);
}

// Reads the value of a key by read(document, node, arguments...); nothing if the key is absent.
template <class Read, class... Arguments>
auto ask(TableState& table, std::string_view key, Read read, const Arguments&... arguments) {
  const toml::node* node = table.ask(key);
  return node != nullptr ? std::optional(read(*table.document, *node, arguments...)) : std::nullopt;
}

// The same, but throws if the key is absent.
template <class Read, class... Arguments>
auto require(TableState& table, std::string_view key, const std::string& form, Read read,
             const Arguments&... arguments) {
  return read(*table.document, table.require(key, form), arguments...);
}

toml::node_type kind(const TableState& table, std::string_view key) {
  const toml::node* node = table.toml->get(key);
  return node != nullptr ? node->type() : toml::node_type::none;
}

using Kind = toml::node_type;

}  // namespace

bool Table::has(std::string_view key) const { return state_->toml->contains(key); }
bool Table::is_table(std::string_view key) const { return kind(*state_, key) == Kind::table; }
bool Table::is_array(std::string_view key) const { return kind(*state_, key) == Kind::array; }
bool Table::is_string(std::string_view key) const { return kind(*state_, key) == Kind::string; }
bool Table::is_number(std::string_view key) const {
  return kind(*state_, key) == Kind::integer || kind(*state_, key) == Kind::floating_point;
}

bool Table::is_inline_table(std::string_view key) const {
  return is_table(key) && state_->toml->get(key)->as_table()->is_inline();
}

double Table::number(std::string_view key, const Range& range) const {
  return require(*state_, key, form(key, "<number>", range), read_number, range);
}

std::optional<double> Table::optional_number(std::string_view key, const Range& range) const {
  return ask(*state_, key, read_number, range);
}

std::int64_t Table::integer(std::string_view key, const Range& range) const {
  return require(*state_, key, form(key, "<whole number>", range), read_integer, range);
}

std::optional<std::int64_t> Table::optional_integer(std::string_view key, const Range& range) const {
  return ask(*state_, key, read_integer, range);
}

bool Table::boolean(std::string_view key) const {
  return require(*state_, key, form(key, "<true or false>"), read_boolean);
}

bool Table::boolean(std::string_view key, bool fallback) const {
  return ask(*state_, key, read_boolean).value_or(fallback);
}

std::string Table::string(std::string_view key) const {
  return require(*state_, key, form(key, "\"<text>\""), read_string);
}

std::optional<std::string> Table::optional_string(std::string_view key) const {
  return ask(*state_, key, read_string);
}

std::string Table::choice(std::string_view key, const Words& allowed) const {
  return require(*state_, key, form(key, any_of(allowed)), read_choice, allowed);
}

std::string Table::choice(std::string_view key, const Words& allowed, std::string_view fallback) const {
  return ask(*state_, key, read_choice, allowed).value_or(std::string(fallback));
}

std::vector<double> Table::numbers(std::string_view key, const Range& range) const {
  return require(*state_, key, form(key, "[<number>, ...]", range), read_numbers, std::nullopt, range);
}

std::vector<double> Table::numbers(std::string_view key, std::size_t count, const Range& range) const {
  return require(*state_, key, form(key, row_form(count), range), read_numbers, count, range);
}

std::vector<std::vector<double>> Table::rows(std::string_view key, std::size_t columns,
                                             const Range& range) const {
  const std::string what = fmt::format("arrays of {} numbers", columns);
  return read_array(*state_->document,
                    state_->require(key, form(key, fmt::format("[{}, ...]", row_form(columns)), range)),
                    std::nullopt, what, read_numbers, columns, range);
}

std::variant<double, Table> Table::number_or_table(std::string_view key) const {
  return read_number_or_table(state_, state_->require(key, form(key, "<number or table>")));
}

std::vector<std::variant<double, Table>> Table::numbers_or_tables(std::string_view key,
                                                                  std::size_t count) const {
  const auto read = [this](const DocumentState&, const toml::node& node) {
    return read_number_or_table(state_, node);
  };
  return read_array(*state_->document, state_->require(key, form(key, row_form(count))), count,
                    "numbers or tables", read);
}

std::vector<std::string> Table::strings(std::string_view key) const {
  return read_array(*state_->document, state_->require(key, form(key, "[\"<text>\", ...]")), std::nullopt,
                    "strings", read_string);
}

std::vector<std::int64_t> Table::integers(std::string_view key, const Range& range) const {
  return read_array(*state_->document, state_->require(key, form(key, "[<whole number>, ...]", range)),
                    std::nullopt, "whole numbers", read_integer, range);
}

std::string Table::toml(std::string_view key) const {
  const std::string text = require(*state_, key, form(key, "<value>"), value_text);
  accept(key);
  return text;
}

std::vector<std::string> Table::toml_elements(std::string_view key) const {
  const auto values = read_array(*state_->document, state_->require(key, form(key, "[<value>, ...]")),
                                 std::nullopt, "values", value_text);
  accept(key);
  return values;
}

}  // namespace scree::document
