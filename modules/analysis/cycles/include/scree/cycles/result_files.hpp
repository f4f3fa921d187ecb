#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/charts/chart_spec.hpp>
#include <scree/cycles/classification.hpp>
#include <scree/cycles/cycles_source.hpp>
#include <scree/cycles/rattlers.hpp>

namespace scree::cycles {

// The cycles of one series and what they are.
struct CyclesResult {
  std::string name;  // of the run
  CyclesSource source;
  Classification found;
  std::size_t drop = 0;
  std::optional<Rattlers> rattlers = {};  // if they were asked for
};

// Of one series: cycles.csv, cycles.json and cycles.png.
inline constexpr const char* table_name = "cycles.csv";
inline constexpr const char* record_name = "cycles.json";
inline constexpr const char* chart_name = "cycles.png";

std::string cycles_table(const CyclesResult& result);
// folder: of the record, which names the series relative to it.
std::string cycles_record(const CyclesResult& result, const std::filesystem::path& folder);
charts::ChartSpec cycles_chart(const CyclesResult& result);

// The series that a record names; empty if there is no such record.
std::filesystem::path series_of_record(const std::filesystem::path& record);

// Of several series: verdicts.csv with a row for each.
inline constexpr const char* verdicts_name = "verdicts.csv";

std::string verdicts_table(const std::vector<CyclesResult>& results, const std::filesystem::path& folder);

// Throws Error for a file that is not such a table, or that has a run which the results lack.
void check_verdicts(const std::filesystem::path& file, const std::vector<CyclesResult>& results);

}  // namespace scree::cycles
