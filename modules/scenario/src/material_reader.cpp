#include "material_reader.hpp"

#include "names.hpp"
#include "scene_keys.hpp"

namespace scree::scenario {

std::vector<Material> read_materials(const document::Table& root) {
  std::vector<Material> materials;
  UniqueNames names("material");
  for (const document::Table& t : root.tables("material")) {
    materials.push_back({read(t, material_keys.name), read(t, material_keys.density)});
    names.add(t, materials.back().name);
  }
  if (materials.empty())
    throw root.error("material", "the scene has no [[material]]",
                     "add [[material]] with name and density (kg/m^3)");
  return materials;
}

std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  return names;
}

}  // namespace scree::scenario
