#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// Index of a word in the names. If it is not there, throws Error at the key, or at an element of its array:
// "no <what> '<word>'; did you mean ...".
std::size_t find_name(const document::Table& table, std::string_view key, std::string_view what,
                      const std::string& word, const std::vector<std::string>& names,
                      std::optional<std::size_t> element = std::nullopt);

// `stages` of the table, each one of these; empty without the key, which stands for all stages. Throws Error
// for an unknown one and for an empty list.
std::vector<std::string> read_stage_names(const document::Table& table,
                                          const std::vector<std::string>& names);

// A set of names that must be different.
class UniqueNames {
 public:
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}
  // Adds a name. Throws Error at `name` of the table if it is empty or already in use.
  void add(const document::Table& table, const std::string& name);
  // Adds and returns the `name` of the table or, without one, the fallback, with _2, _3, ... if it is in use.
  std::string add_or_number(const document::Table& table, const std::string& fallback);

 private:
  std::string what_;  // kind of the named things, for messages
  std::set<std::string> taken_;
};

// Throws Error at `name` of the table unless it is usable as a file name: letters, digits, '_' and '-'.
void check_file_name(const document::Table& table, const std::string& name);

}  // namespace scree::scenario
