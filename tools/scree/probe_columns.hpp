#pragma once

#include <string>
#include <vector>

#include <scree/parameters.hpp>

namespace scree::tool {

// A column of the series of a probe, or several whose names differ in numbers only, which are <n> in the
// name.
struct ColumnLine {
  std::string name;
  std::string unit;     // "1" if dimensionless
  std::string meaning;  // also whether it is there in 2D or 3D only; empty if the plug-in says nothing
};

// The columns of a probe with these parameters; those that are required and not given, and lists, have
// examples as values. Empty if the plug-in refuses the examples.
std::vector<ColumnLine> described_columns(const Parameters& probe);

}  // namespace scree::tool
