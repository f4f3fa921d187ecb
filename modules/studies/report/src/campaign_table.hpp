#pragma once

#include "results.hpp"
#include "text_table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace scree::report {

// A mean over runs, with its standard error; NaN where there are none.
struct Mean {
  double mean, standard_error;
};

// Runs that differ in their seed only.
struct Combination {
  std::vector<std::string> values;  // of the keys, as in the table
  std::vector<std::size_t> rows;    // of finished runs
};

// The table of a campaign by its combinations.
class CampaignTable {
 public:
  explicit CampaignTable(const Results& results);

  const TextTable& table() const { return table_; }
  const std::vector<std::string>& keys() const { return keys_; }              // that vary, without the seed
  const std::vector<std::string>& quantities() const { return quantities_; }  // that were collected
  const std::vector<Combination>& combinations() const { return combinations_; }

  Mean mean(const Combination& combination, const std::string& quantity) const;
  // Whether a key has two or more values, all of them numbers.
  bool is_numeric(std::size_t key) const;
  // The name of a key without the tables in which it is, unless two keys would have that name.
  std::string short_name(std::size_t key) const;
  // Of a quantity, from a series of the first run that has one; empty if that is not known.
  std::string unit(const std::string& quantity) const;

 private:
  void find_quantities(const Json& record);

  const Results& results_;
  TextTable table_;
  std::vector<std::string> keys_, quantities_;
  std::vector<Combination> combinations_;
};

}  // namespace scree::report
