#include "material_reader.hpp"

#include "scene_keys.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/packing/csv.hpp>
#include <scree/scenario/names.hpp>

namespace scree::scenario {

namespace {

// The law of every two materials is stored.
constexpr std::size_t most_materials = 1000;

// final_packing.csv holds the names as cells.
void check_name(const document::Table& t, const std::string& name) {
  if (!packing::fits_csv_cell(name))
    throw t.error("name",
                  fmt::format("the material name '{}' cannot be written to a packing", files::one_line(name)),
                  "rename it without commas, quotes, control characters and leading or trailing blanks");
}

}  // namespace

std::vector<Material> read_materials(const document::Table& root) {
  std::vector<Material> materials;
  UniqueNames names("material");
  for (const document::Table& t : root.tables("material")) {
    if (materials.size() == most_materials)
      throw t.error(fmt::format("the scene has more than {} materials", most_materials),
                    "merge those of the same density and contacts");
    const std::string name = read(t, material_keys.name);
    check_name(t, name);
    names.add(t, name);
    materials.push_back({name, read(t, material_keys.density)});
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
