#include "h5md_place.hpp"

#include <algorithm>
#include <string_view>

namespace scree::state_file {
namespace {

constexpr std::string_view bodies = "bodies/", elements = "particles/bodies/", value = "/value";
constexpr std::string_view material = "material", species = "species", box = "box";
// Names of arrays that do not change in a run.
constexpr std::string_view constant[] = {"fixed", "held", "id", "inertia", "mass", "material", "radius"};

}  // namespace

std::optional<H5mdPlace> h5md_place(const std::string& path) {
  if (!path.starts_with(bodies)) return std::nullopt;
  const std::string name = path.substr(bodies.size());
  if (name.find('/') != name.npos || name == box || name == species) return std::nullopt;
  const bool is_constant = std::find(std::begin(constant), std::end(constant), name) != std::end(constant);
  return H5mdPlace{std::string(elements) + (name == material ? std::string(species) : name), !is_constant};
}

std::optional<std::string> path_at(const std::string& dataset) {
  if (!dataset.starts_with(elements)) return std::nullopt;
  std::string name = dataset.substr(elements.size());
  if (name.ends_with(value)) name.resize(name.size() - value.size());
  const std::string path = std::string(bodies) + (name == species ? std::string(material) : name);
  const auto place = h5md_place(path);
  return place && place->dataset() == dataset ? std::optional(path) : std::nullopt;
}

}  // namespace scree::state_file
