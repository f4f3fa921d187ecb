#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// One [[material]].
struct Material {
  std::string name;
  double density;  // (kg/m³)
};

// At least one. Throws Error where there is none or two have the same name.
std::vector<Material> read_materials(const document::Table& root);

std::vector<std::string> names_of(const std::vector<Material>& materials);

}  // namespace scree::scenario
