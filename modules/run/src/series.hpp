#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace scree::run {

// Rows of one probe: kept in memory for charts and expectations, and written to a CSV file, if there is one,
// during the run. Functions that write throw Error (failure) if the file cannot be written.
class Series {
 public:
  // Header "time [s],<name> [<unit>],...", with `staged` a last column "stage"; numbers in the shortest decimal
  // form with the same bits.
  Series(const std::filesystem::path& file, std::vector<std::string> names,
         const std::vector<std::string>& units, bool staged);
  explicit Series(std::vector<std::string> names);
  // How far a series has come.
  struct Position {
    std::uint64_t rows = 0, bytes = 0, stage = 1;
    double last_time = 0;
  };
  // Goes on with a file at a position.
  Series(const std::filesystem::path& file, std::vector<std::string> names, const Position& position,
         bool staged);
  Position position();

  void add(double time, const std::vector<double>& row);
  // Rows added from now on belong to the stage of this number, from 1.
  void begin_stage(std::size_t number) { stage_ = number; }
  void flush();

  // A column by name, including "time".
  const std::vector<double>& column(const std::string& name) const;
  std::size_t rows() const { return columns_[0].size(); }

 private:
  void check_file() const;

  std::filesystem::path path_;
  std::ofstream file_;
  bool staged_ = false;
  std::size_t stage_ = 1;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace scree::run
