#include "series.hpp"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>

#include <scree/run/run_directory.hpp>

namespace scree::run {

Series::Series(const std::filesystem::path& file, std::vector<std::string> names,
               const std::vector<std::string>& units, bool staged)
    : Series(std::move(names)) {
  staged_ = staged;
  path_ = file;
  std::error_code failed;  // a failure is reported when the file is opened
  std::filesystem::create_directories(file.parent_path(), failed);
  file_.open(file, std::ios::binary);
  file_ << "time [s]";
  for (std::size_t k = 0; k < units.size(); ++k)
    file_ << ',' << names_[k + 1] << (units[k].empty() ? "" : fmt::format(" [{}]", units[k]));
  file_ << (staged ? ",stage\n" : "\n");
  flush();
}

Series::Series(std::vector<std::string> names) : names_(std::move(names)) {
  names_.insert(names_.begin(), "time");
  columns_.resize(names_.size());
}

Series::Series(const std::filesystem::path& file, std::vector<std::string> names, const Position& position,
               bool staged)
    : Series(std::move(names)) {
  staged_ = staged;
  stage_ = position.stage;
  path_ = file;
  std::filesystem::resize_file(file, position.bytes);
  file_.open(file, std::ios::binary | std::ios::app | std::ios::ate);
}
Series::Position Series::position() {
  return {rows(), std::uint64_t(file_.tellp()), stage_, rows() ? columns_[0].back() : 0};
}

void Series::add(double time, const std::vector<double>& row) {
  columns_[0].push_back(time);
  for (std::size_t k = 0; k < row.size(); ++k) columns_[k + 1].push_back(row[k]);
  if (path_.empty()) return;
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "{}", time);
  for (const double number : row) fmt::format_to(std::back_inserter(line), ",{}", number);
  if (staged_) fmt::format_to(std::back_inserter(line), ",{}", stage_);
  line.push_back('\n');
  file_.write(line.data(), std::streamsize(line.size()));
  check_file();
}

void Series::flush() {
  file_.flush();
  check_file();
}

void Series::check_file() const {
  if (!path_.empty() && !file_) throw unwritable(path_, errno);
}

const std::vector<double>& Series::column(const std::string& name) const {
  return columns_.at(std::size_t(std::find(names_.begin(), names_.end(), name) - names_.begin()));
}

}  // namespace scree::run
