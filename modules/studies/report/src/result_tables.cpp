#include <scree/files/csv_rows.hpp>
#include <scree/report/result_tables.hpp>

namespace scree::report {

namespace fs = std::filesystem;

std::map<std::string, fs::path> tables_in(const fs::path& directory) {
  std::map<std::string, fs::path> tables;
  std::error_code failed;
  for (const fs::path& folder : {directory / "series", directory})
    for (const auto& entry : fs::directory_iterator(folder, failed))
      if (entry.path().extension() == ".csv") tables.emplace(entry.path().stem().string(), entry.path());
  return tables;
}

std::vector<scenario::ProbeColumns> columns_of(const std::map<std::string, fs::path>& tables) {
  std::vector<scenario::ProbeColumns> probes;
  for (const auto& [name, file] : tables) {
    probes.push_back({name, {}, {}});
    const files::CsvRows rows(file);
    for (const files::CsvRows::Column& column : rows.columns()) {
      probes.back().names.push_back(column.name);
      probes.back().units.push_back(column.unit);
    }
  }
  return probes;
}

}  // namespace scree::report
