#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <scree/scenario/charts.hpp>

namespace scree::report {

// The tables of a run or study by their names: its series, then what lies beside its record.
std::map<std::string, std::filesystem::path> tables_in(const std::filesystem::path& directory);

// Their columns. Throws Error if a table has no header.
std::vector<scenario::ProbeColumns> columns_of(const std::map<std::string, std::filesystem::path>& tables);

}  // namespace scree::report
