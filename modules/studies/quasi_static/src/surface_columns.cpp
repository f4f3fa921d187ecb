#include "surface_columns.hpp"

#include <cstdint>

#include <scree/wall_surfaces.hpp>

namespace scree::quasi_static {

SurfaceColumns::SurfaceColumns(const Simulation& simulation) {
  const WallEquations equations = simulation.linear_walls();
  const std::size_t planes = simulation.planes().size();
  for (std::size_t s = 0; s < simulation.surfaces().size(); ++s)
    if (const scree_linear_wall& wall = equations.walls[planes + s]; wall.free == SCREE_FREE)
      surfaces_.push_back({simulation.surfaces().names[s], s, vector_of(wall.direction)});
}

void SurfaceColumns::begin(const Sample& start) {
  for (Moved& surface : surfaces_) surface.at_start = vector_of(start.frames[surface.number].position);
}

std::vector<std::string> SurfaceColumns::names() const {
  std::vector<std::string> all;
  for (const Moved& surface : surfaces_) {
    all.push_back("displacement_" + surface.name + " [m]");
    all.push_back("force_" + surface.name + " [N]");
  }
  return all;
}

std::vector<double> SurfaceColumns::numbers(const Sample& sample) const {
  std::vector<double> all;
  for (const Moved& surface : surfaces_) {
    const Vec3 place = vector_of(sample.frames[surface.number].position);
    all.push_back(dot(surface.direction, place - surface.at_start));
    all.push_back(-dot(surface.direction, vector_of(sample.surface_loads[surface.number].force)));
  }
  return all;
}

void SurfaceColumns::transfer(const StateTransfer& state) {
  std::vector<std::uint64_t> numbers;
  std::vector<double> directions, places;
  const auto append = [](std::vector<double>& all, const Vec3& v) {
    all.insert(all.end(), v.component, v.component + 3);
  };
  for (const Moved& surface : surfaces_) {
    numbers.push_back(surface.number);
    append(directions, surface.direction), append(places, surface.at_start);
  }
  state.rows("numbers", "1", numbers);
  directions.resize(3 * numbers.size()), places.resize(3 * numbers.size());
  state.sized_rows("directions", "1", directions, 3);
  state.sized_rows("at_start", "m", places, 3);
  if (!state.restoring()) return;
  surfaces_.clear();
  const auto vector = [](const std::vector<double>& all, std::size_t k) {
    return Vec3{{all[3 * k], all[3 * k + 1], all[3 * k + 2]}};
  };
  for (std::size_t k = 0; k < numbers.size(); ++k)
    surfaces_.push_back({"", std::size_t(numbers[k]), vector(directions, k), vector(places, k)});
}

void SurfaceColumns::restore(const StateTransfer& state, const std::vector<std::string>& names) {
  for (Moved& surface : surfaces_) {
    if (surface.number >= names.size()) state.refuse("numbers", "has a surface that the scene does not have");
    surface.name = names[surface.number];
  }
}

}  // namespace scree::quasi_static
