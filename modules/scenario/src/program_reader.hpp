#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// Reads a function of time: a number, or a table whose keys determine its kind. Returns the numbers of a Program
// (see program.hpp of the framework).
std::vector<double> read_program(const document::Table& table, const std::string& key);

}  // namespace scree::scenario
