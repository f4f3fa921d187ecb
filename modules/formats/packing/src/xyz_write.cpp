#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>
#include <scree/packing/exports.hpp>

namespace scree::packing {

namespace {

constexpr std::string_view elements[] = {"H",  "He", "Li", "Be", "B", "C", "N",  "O",  "F", "Ne",
                                         "Na", "Mg", "Al", "Si", "P", "S", "Cl", "Ar", "K", "Ca"};

// Materials in the order in which bodies have them.
std::vector<std::string> materials_of(const Packing& packing) {
  std::vector<std::string> names;
  for (const Body& body : packing.bodies)
    if (std::find(names.begin(), names.end(), body.material) == names.end()) names.push_back(body.material);
  if (names.size() > std::size(elements))
    throw Error("packing", fmt::format("{} materials are more than {}", names.size(), std::size(elements)),
                "export another format");
  return names;
}

// Quotes of a value in the second line cannot be escaped for all readers.
std::string plain(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == '"' || c == '\\' || c == ' '; },
      '_');
  return name.empty() ? "unnamed" : name;
}

std::string heading(const Packing& packing, const std::vector<std::string>& materials, bool with_mass) {
  const Bounds box = packing.bounds ? *packing.bounds : enclosing_bounds(packing);
  Vec3 length = box.upper - box.lower;
  // A cell has a volume.
  for (int k = 0; k < 3; ++k)
    if (!(length[k] > 0)) length[k] = 1;
  std::vector<std::string> names;
  for (const std::string& name : materials) names.push_back(plain(name));
  std::vector<const char*> periodic;
  for (const bool axis : packing.periodic) periodic.push_back(axis ? "T" : "F");
  return fmt::format(
      "Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" "
      "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:omega:R:3{}:id:I:1 pbc=\"{}\" Time={} materials=\"{}\"\n",
      length[0], length[1], length[2], box.lower[0], box.lower[1], box.lower[2], with_mass ? ":mass:R:1" : "",
      fmt::join(periodic, " "), packing.time, fmt::join(names, " "));
}

}  // namespace

std::string format_xyz(const Packing& packing) {
  check(packing);
  const std::vector<std::string> materials = materials_of(packing);
  const bool with_mass = std::none_of(packing.bodies.begin(), packing.bodies.end(),
                                      [](const Body& b) { return std::isnan(b.mass); });
  std::string out = fmt::format("{}\n", packing.bodies.size()) + heading(packing, materials, with_mass);
  const auto end = std::back_inserter(out);
  for (const Body& b : packing.bodies) {
    const auto type = std::find(materials.begin(), materials.end(), b.material) - materials.begin();
    fmt::format_to(end, "{} {} {} {} {} {} {} {} {} {} {}", elements[type], b.position[0], b.position[1],
                   b.position[2], b.radius, b.velocity[0], b.velocity[1], b.velocity[2], b.spin[0], b.spin[1],
                   b.spin[2]);
    if (with_mass) fmt::format_to(end, " {}", b.mass);
    fmt::format_to(end, " {}\n", b.id);
  }
  return out;
}

std::string format_yade(const Packing& packing) {
  check(packing);
  std::string out = "#format x_y_z_r\n";
  for (const Body& b : packing.bodies)
    fmt::format_to(std::back_inserter(out), "{}\t{}\t{}\t{}\n", b.position[0], b.position[1], b.position[2],
                   b.radius);
  return out;
}

}  // namespace scree::packing
