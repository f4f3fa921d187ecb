#include "document_read.hpp"

#include "document_message.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

Error wrong_type(const DocumentState& state, const Node& node, const std::string& cure) {
  return state.error(node, fmt::format("{} is {}", node.path(), node.description()), "give " + cure);
}

// The noun of a value in a cure: the key of the value or of the array that holds it.
std::string noun(const Node& node) {
  const Node* named = &node;
  while (named->key.empty() && named->parent != nullptr) named = named->parent;
  return named == &node ? with_article(node.key) : "numbers";
}

Error out_of_range(const DocumentState& state, const Node& node, const std::string& shown, double value,
                   const Range& range) {
  const std::string unit = range.unit().empty() ? "" : " " + range.unit();
  return state.error(node, fmt::format("{} = {}{} {}", node.path(), shown, unit, range.fault(value)),
                     fmt::format("give {} {}", noun(node), range.wanted()));
}

// A number in quotes is the commonest slip: then the cure repeats the number.
std::string number_cure(const Node& node, const Range& range) {
  std::string cure = "a number" + (range.unit().empty() ? "" : " in " + range.unit());
  if (node.kind != NodeKind::string || node.text.empty()) return cure;
  double value = 0;
  const char* end = node.text.data() + node.text.size();
  const auto [stop, failure] = std::from_chars(node.text.data(), end, value);
  const bool whole = failure == std::errc() && stop == end;
  return whole && std::isfinite(value) ? cure + ", such as " + number_text(value) : cure;
}

std::string array_form(std::optional<std::size_t> count, std::string_view what) {
  return count ? fmt::format("an array of {} {}", *count, what) : fmt::format("an array of {}", what);
}

}  // namespace

void check_array(const DocumentState& state, const Node& node, std::optional<std::size_t> count,
                 std::string_view what) {
  if (node.kind != NodeKind::array) throw wrong_type(state, node, array_form(count, what));
  if (!count || node.children.size() == *count) return;
  const std::size_t size = node.children.size();
  throw state.error(node, fmt::format("{} has {} {}", node.path(), size, size == 1 ? "element" : "elements"),
                    "give " + array_form(count, what));
}

double read_number(const DocumentState& state, const Node& node, const Range& range) {
  if (!node.is_number()) throw wrong_type(state, node, number_cure(node, range));
  const double value = node.kind == NodeKind::integer ? static_cast<double>(node.integer) : node.number;
  if (!std::isfinite(value)) {
    throw state.error(node, fmt::format("{} = {} is not finite", node.path(), toml_number_text(value)),
                      "give " + number_cure(node, range));
  }
  if (!range.contains(value)) throw out_of_range(state, node, number_text(value), value, range);
  return value;
}

std::int64_t read_integer(const DocumentState& state, const Node& node, const Range& range) {
  if (node.kind != NodeKind::integer) {
    const bool whole = node.kind == NodeKind::number && std::abs(node.number) < 1e15 &&
                       std::trunc(node.number) == node.number;
    const std::string example = whole ? fmt::format(", such as {:.0f}", node.number) : "";
    throw wrong_type(state, node, "a whole number without a decimal point or exponent" + example);
  }
  const double value = static_cast<double>(node.integer);
  if (!range.contains(value)) throw out_of_range(state, node, std::to_string(node.integer), value, range);
  return node.integer;
}

bool read_boolean(const DocumentState& state, const Node& node) {
  if (node.kind != NodeKind::boolean) throw wrong_type(state, node, "true or false");
  return node.boolean;
}

std::string read_string(const DocumentState& state, const Node& node) {
  if (node.kind != NodeKind::string) throw wrong_type(state, node, "a string in quotes");
  return node.text;
}

std::string read_choice(const DocumentState& state, const Node& node,
                        const std::vector<std::string>& allowed) {
  if (node.kind != NodeKind::string) throw wrong_type(state, node, any_of(allowed, "\""));
  for (const std::string& word : allowed) {
    if (word == node.text) return word;
  }
  const std::string hint = suggestion(node.text, allowed);
  throw Error(fmt::format("{}: {} = \"{}\" is none of the choices{} give {}", state.place_text(node),
                          node.path(), files::one_line(node.text), hint.empty() ? ";" : hint,
                          any_of(allowed, "\"")));
}

std::vector<double> read_numbers(const DocumentState& state, const Node& node,
                                 std::optional<std::size_t> count, const Range& range) {
  check_array(state, node, count, range.unit().empty() ? "numbers" : "numbers in " + range.unit());
  std::vector<double> values;
  values.reserve(node.children.size());
  for (const auto& element : node.children) values.push_back(read_number(state, *element, range));
  return values;
}

std::vector<std::vector<double>> read_rows(const DocumentState& state, const Node& node, std::size_t columns,
                                           const Range& range) {
  check_array(state, node, std::nullopt, fmt::format("arrays of {} numbers", columns));
  std::vector<std::vector<double>> rows;
  rows.reserve(node.children.size());
  for (const auto& row : node.children) rows.push_back(read_numbers(state, *row, columns, range));
  return rows;
}

std::vector<std::string> read_strings(const DocumentState& state, const Node& node) {
  check_array(state, node, std::nullopt, "strings");
  std::vector<std::string> values;
  values.reserve(node.children.size());
  for (const auto& element : node.children) values.push_back(read_string(state, *element));
  return values;
}

std::vector<std::int64_t> read_integers(const DocumentState& state, const Node& node, const Range& range) {
  check_array(state, node, std::nullopt, "whole numbers");
  std::vector<std::int64_t> values;
  values.reserve(node.children.size());
  for (const auto& element : node.children) values.push_back(read_integer(state, *element, range));
  return values;
}

}  // namespace scree::document
