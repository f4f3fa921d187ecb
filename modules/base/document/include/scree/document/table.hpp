#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <scree/document/range.hpp>
#include <scree/error.hpp>

namespace scree::document {

struct TableState;

// Handle to one table of a Document. It is cheap to copy and keeps the document alive.
// Functions that read a value mark its key as known to refuse_unused(), whether or not it is present; has(),
// is_table() and the like, place() and error() do not. A reader without a fallback throws if the key is
// absent; every reader throws if the type is wrong or the value is out of range. All throw Error (bad_input),
// one line "file:line:column: what is wrong; what to do".
class Table {
 public:
  static constexpr std::size_t whole = static_cast<std::size_t>(-1);  // the whole array, not one element

  explicit Table(std::shared_ptr<TableState> state) : state_(std::move(state)) {}

  // Path, "contact[1]" (index from 0, omitted if there is only one entry); empty for the root.
  std::string path() const;
  // Name in the notation of the file: "[time]", "[[contact]]"; "the file" for the root.
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

  // A finite number, written with or without a decimal point.
  double number(std::string_view key, const Range& range = Range::any()) const;
  double number(std::string_view key, double fallback, const Range& range = Range::any()) const {
    return optional_number(key, range).value_or(fallback);
  }
  std::optional<double> optional_number(std::string_view key, const Range& range = Range::any()) const;

  // A whole number, written without a decimal point or exponent.
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

  // A string that is one of `allowed`.
  std::string choice(std::string_view key, const std::vector<std::string>& allowed) const;
  std::string choice(std::string_view key, const std::vector<std::string>& allowed,
                     std::string_view fallback) const;

  // Array of numbers, of any length or of `count` elements.
  std::vector<double> numbers(std::string_view key, const Range& range = Range::any()) const;
  std::vector<double> numbers(std::string_view key, std::size_t count,
                              const Range& range = Range::any()) const;
  // Array of any number of rows, each an array of `columns` numbers.
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns,
                                        const Range& range = Range::any()) const;
  // A number or a table; and an array of `count` of them.
  std::variant<double, Table> number_or_table(std::string_view key) const;
  std::vector<std::variant<double, Table>> numbers_or_tables(std::string_view key, std::size_t count) const;
  std::vector<std::string> strings(std::string_view key) const;
  std::vector<std::int64_t> integers(std::string_view key, const Range& range = Range::any()) const;

  // Any value as TOML on one line, in a form that an override accepts; or each element of an array. All keys
  // below the value become known.
  std::string toml(std::string_view key) const;
  std::vector<std::string> toml_elements(std::string_view key) const;

  Table table(std::string_view key) const;
  std::optional<Table> optional_table(std::string_view key) const;
  // An absent table is read as an empty one, with the place of this table.
  Table table_or_empty(std::string_view key) const;
  // Entries of [[key]]; one entry for [key]; none if the key is absent.
  std::vector<Table> tables(std::string_view key) const;

  // Marks the key and all keys below it as known without reading them.
  void accept(std::string_view key) const;
  // Marks a key as known and returns whether it is present. For keys that are read only in some cases.
  bool optional(std::string_view key) const;
  // Throws for the first key, in file order, of this table or the tables below it that is not known.
  void refuse_unused() const;

  // End of the cure for a missing key: ", or correct 'stifness' (file:line:column) if that is meant" for a
  // key that is not known and is spelt similarly; empty if there is none.
  std::string misspelt(std::string_view missing) const;

  // "file:line:column" of the table; or of the value of a key, of one element (from 0) of its array, or of
  // the table if the key is absent; "--set key=value" for values written by an override.
  std::string place() const;
  std::string place(std::string_view key, std::size_t element = whole) const;
  // Error "place: what; cure", for the caller to throw.
  Error error(std::string_view what, std::string_view cure) const;
  Error error(std::string_view key, std::string_view what, std::string_view cure) const;
  // Placed at one element (from 0) of the array under key.
  Error error(std::string_view key, std::size_t element, std::string_view what, std::string_view cure) const;
  // Placed at a byte of the string under key; at the string, with the number of the character, where the file
  // writes it with escapes or in several lines.
  Error error_in_string(std::string_view key, std::size_t byte, std::string_view what,
                        std::string_view cure) const;

 private:
  std::shared_ptr<TableState> state_;
};

}  // namespace scree::document
