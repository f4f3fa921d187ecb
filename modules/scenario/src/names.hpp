#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// Index of a word among the names. Throws Error at the key, or at that element of the array under it:
// "no <what> '<word>'; did you mean ...".
std::size_t find_name(const document::Table& table, std::string_view key, std::string_view what,
                      const std::string& word, const std::vector<std::string>& names,
                      std::optional<std::size_t> element = std::nullopt);

// Names that must all differ.
class UniqueNames {
 public:
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}
  // Throws Error at `name` of the table if it is empty or taken.
  void add(const document::Table& table, const std::string& name);
  // The `name` of the table or, where it gives none, the fallback, numbered from the second on; added.
  std::string add_or_number(const document::Table& table, const std::string& fallback);

 private:
  std::string what_;  // they are of
  std::set<std::string> taken_;
};

// Throws Error at `name` of the table unless it is fit for a file: letters, digits, '_' and '-'.
void check_file_name(const document::Table& table, const std::string& name);

}  // namespace scree::scenario
