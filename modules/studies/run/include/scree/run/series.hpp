#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/run/line_file.hpp>

namespace scree::run {

// Where a series ended when its run was saved.
struct SeriesEnd {
  std::uint64_t bytes = 0;  // of its file, at the end of a line
  std::size_t rows = 0;
  double last_time = 0;  // (s) of the last row; 0 without rows
};

// Rows of one probe: in a CSV file, written during the run, or in memory if there is none. Functions that
// write throw Error (failure) if the file cannot be written; it is cut back to its last whole row then.
class Series {
 public:
  // Header "time [s],<name> [<unit>],...", with `staged` a last column "stage"; numbers in the shortest
  // decimal form with the same bits.
  Series(const std::filesystem::path& file, std::vector<std::string> names,
         const std::vector<std::string>& units, bool staged);
  // Goes on with such a file behind its former end; cut() drops later rows. Throws Error if the file is not
  // as it was up to there.
  Series(const std::filesystem::path& file, std::vector<std::string> names, bool staged,
         const SeriesEnd& end);
  void cut();
  explicit Series(std::vector<std::string> names);
  void add(double time, const std::vector<double>& row);
  // Rows added from now on belong to the stage of this number, from 1.
  void begin_stage(std::size_t number) { stage_ = number; }
  void flush();

  // A column by name, including "time"; from a file the rows before the last flush(). Throws Error (failure)
  // if the file was changed.
  std::vector<double> column(const std::string& name) const;
  std::size_t rows() const { return rows_; }
  double last_time() const { return last_time_; }  // (s) of the last row
  // Bytes of the file at the last flush(); 0 without a file.
  std::uint64_t bytes() const { return file_ ? file_->bytes() : 0; }

 private:
  std::optional<LineFile> file_;
  bool staged_ = false;
  std::size_t stage_ = 1, rows_ = 0;
  double last_time_ = 0;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;  // only without a file
};

// A column of the CSV file of a series, by its name without unit, with the bits that were written. Throws
// Error "<file>: <what is wrong>; <cure>" if it is missing, or a line is not as a run wrote it.
std::vector<double> series_column(const std::filesystem::path& file, const std::string& name,
                                  const std::string& cure);

}  // namespace scree::run
