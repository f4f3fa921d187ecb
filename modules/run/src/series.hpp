#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace scree::run {

// The rows of one probe: kept for charts and expectations, and written as CSV while the run goes on, unless
// it was made without a file.
// Every function that writes throws Error (failure) when the disk refuses.
class Series {
 public:
  // Header "time [s],<name> [<unit>],..."; numbers in the shortest form that reads back the same bits.
  Series(const std::filesystem::path& file, std::vector<std::string> names,
         const std::vector<std::string>& units);
  explicit Series(std::vector<std::string> names);

  void add(double time, const std::vector<double>& row);
  void flush();

  // A column by name, "time" included.
  const std::vector<double>& column(const std::string& name) const;
  std::size_t rows() const { return columns_[0].size(); }

 private:
  void check_file() const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace scree::run
