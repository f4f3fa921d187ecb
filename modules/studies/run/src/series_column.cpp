#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/run/series_column.hpp>

namespace scree::run {

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
    const std::string line = error.what();
    throw Error(line.substr(0, line.find("; ", file.string().size())) + "; " + cure, ExitStatus::failure);
  }
}

}  // namespace scree::run
