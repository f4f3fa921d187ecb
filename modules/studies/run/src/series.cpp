#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/run/series.hpp>

namespace scree::run {

Series::Series(const std::filesystem::path& file, std::vector<std::string> names,
               const std::vector<std::string>& units, bool staged)
    : Series(std::move(names)) {
  staged_ = staged;
  file_.emplace(file);
  std::string header = "time [s]";
  for (std::size_t k = 0; k < units.size(); ++k)
    header += ',' + names_[k + 1] + (units[k].empty() ? "" : fmt::format(" [{}]", units[k]));
  file_->add(header + (staged ? ",stage\n" : "\n"));
  flush();
}

Series::Series(const std::filesystem::path& file, std::vector<std::string> names, bool staged,
               const SeriesEnd& end)
    : Series(std::move(names)) {
  staged_ = staged;
  file_.emplace(file, end.bytes);
  rows_ = end.rows;
  last_time_ = end.last_time;
}

Series::Series(std::vector<std::string> names) : names_(std::move(names)) {
  names_.insert(names_.begin(), "time");
  columns_.resize(names_.size());
}

void Series::add(double time, const std::vector<double>& row) {
  ++rows_;
  last_time_ = time;
  if (!file_) {
    columns_[0].push_back(time);
    for (std::size_t k = 0; k < row.size(); ++k) columns_[k + 1].push_back(row[k]);
    return;
  }
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "{}", time);
  // The sign of 0/0 differs between processors and compilers.
  for (const double number : row)
    fmt::format_to(std::back_inserter(line), ",{}", std::isnan(number) ? std::abs(number) : number);
  if (staged_) fmt::format_to(std::back_inserter(line), ",{}", stage_);
  line.push_back('\n');
  file_->add({line.data(), line.size()});
}

void Series::cut() {
  if (file_) file_->cut();
}

void Series::flush() {
  if (file_) file_->flush();
}

std::vector<double> Series::column(const std::string& name) const {
  if (file_) return series_column(file_->path(), name, "leave the files of a run alone until it ends");
  return columns_.at(std::size_t(std::find(names_.begin(), names_.end(), name) - names_.begin()));
}

namespace {

std::vector<double> read_column(const std::filesystem::path& file, const std::string& name) {
  files::CsvRows rows(file);
  const auto check_whole = [&] {
    if (!rows.is_whole()) rows.fail(1, "the line is cut off", "");
  };
  check_whole();
  const std::size_t column = rows.column(name);
  std::vector<double> values;
  while (rows.next()) {
    check_whole();
    values.push_back(rows.any_number(column));
  }
  return values;
}

}  // namespace

std::vector<double> series_column(const std::filesystem::path& file, const std::string& name,
                                  const std::string& cure) {
  try {
    return read_column(file, name);
  } catch (const Error& error) {
    // A run has written the file, so that no cure is to write it otherwise.
    throw Error(error.place(), error.problem(), cure, ExitStatus::failure);
  }
}

}  // namespace scree::run
