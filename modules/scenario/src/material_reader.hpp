#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// A [[material]].
struct Material {
  std::string name;
  double density;  // (kg/m³)
};

// Reads all materials. Throws Error if there is none or two have the same name.
std::vector<Material> read_materials(const document::Table& root);

std::vector<std::string> names_of(const std::vector<Material>& materials);

}  // namespace scree::scenario
