#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <scree/document/range.hpp>
#include <scree/error.hpp>

namespace scree::document {

struct TableState;

// One table of a Document: a handle, cheap to copy, that keeps the document alive.
// Every reader makes its key known to refuse_unused(), present or not; questions, places and errors do not. A
// reader without a fallback throws when the key is absent; every reader throws on a wrong type or a value out
// of range. All throw Error (bad_input), one line "file:line:column: what is wrong; what to do".
class Table {
 public:
  static constexpr std::size_t whole = static_cast<std::size_t>(-1);  // all of an array

  explicit Table(std::shared_ptr<TableState> state) : state_(std::move(state)) {}

  // "contact[1]" (index from 0, left out where there is one entry); empty at the top level.
  std::string path() const;
  // As written in the file: "[time]", "[[contact]]", "the file".
  std::string label() const;
  // Keys present, in file order.
  std::vector<std::string> keys() const;

  bool has(std::string_view key) const;
  bool is_table(std::string_view key) const;
  bool is_array(std::string_view key) const;   // also an array of tables
  bool is_number(std::string_view key) const;  // integer or floating-point
  bool is_string(std::string_view key) const;
  // A table written on one line, as { a = 1 }.
  bool is_inline_table(std::string_view key) const;

  // Finite; written with or without a decimal point.
  double number(std::string_view key, const Range& range = Range::any()) const;
  double number(std::string_view key, double fallback, const Range& range = Range::any()) const {
    return optional_number(key, range).value_or(fallback);
  }
  std::optional<double> optional_number(std::string_view key, const Range& range = Range::any()) const;

  // Written without a decimal point or exponent.
  std::int64_t integer(std::string_view key, const Range& range = Range::any()) const;
  std::int64_t integer(std::string_view key, std::int64_t fallback, const Range& range = Range::any()) const {
    return optional_integer(key, range).value_or(fallback);
  }
  std::optional<std::int64_t> optional_integer(std::string_view key, const Range& range = Range::any()) const;

  bool boolean(std::string_view key) const;
  bool boolean(std::string_view key, bool fallback) const;

  std::string string(std::string_view key) const;
  std::string string(std::string_view key, std::string_view fallback) const {
    return optional_string(key).value_or(std::string(fallback));
  }
  std::optional<std::string> optional_string(std::string_view key) const;

  // A string out of allowed.
  std::string choice(std::string_view key, const std::vector<std::string>& allowed) const;
  std::string choice(std::string_view key, const std::vector<std::string>& allowed,
                     std::string_view fallback) const;

  // (any length), or (count).
  std::vector<double> numbers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<double> numbers(std::string_view key, std::size_t count,
                              const Range& range = Range::any()) const;
  // (any number of rows, columns).
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns,
                                        const Range& range = Range::any()) const;
  std::vector<std::string> strings(std::string_view key) const;
  std::vector<std::int64_t> integers(std::string_view key, const Range& range = Range::any()) const;

  // Any value as TOML in one line, as an override takes it, with all below it known; or each element of an
  // array.
  std::string toml(std::string_view key) const;
  std::vector<std::string> toml_elements(std::string_view key) const;

  Table table(std::string_view key) const;
  std::optional<Table> optional_table(std::string_view key) const;
  // An absent table reads as an empty one, placed where this table is.
  Table table_or_empty(std::string_view key) const;
  // Entries of [[key]]; one entry for [key]; none when absent.
  std::vector<Table> tables(std::string_view key) const;

  // Counts the key and all below it as known without reading it.
  void accept(std::string_view key) const;
  // Whether an optional key is there, which is known from now on: for one that is read only in some cases.
  bool optional(std::string_view key) const;
  // Throws for the first key, in file order, of this table and those below that no reader has asked for.
  void refuse_unused() const;

  // "file:line:column" of the table; or of the value of a key, of one element (from 0) of its array, or of
  // the table when the key is absent; "--set key=value" for what an override has written.
  std::string place() const;
  std::string place(std::string_view key, std::size_t element = whole) const;
  // "place: what; cure", to be thrown.
  Error error(std::string_view what, std::string_view cure) const;
  Error error(std::string_view key, std::string_view what, std::string_view cure) const;
  // Placed at one element (from 0) of the array under key.
  Error error(std::string_view key, std::size_t element, std::string_view what, std::string_view cure) const;

 private:
  std::shared_ptr<TableState> state_;
};

}  // namespace scree::document
