#include "frame_check.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::pictures {
namespace {

template <class T>
void check_length(const char* name, const std::vector<T>& column, std::size_t expected, bool may_be_empty) {
  if (column.size() == expected || (may_be_empty && column.empty())) return;
  throw Error(fmt::format("frame: column {} has {} values instead of {}; fill every column of the frame",
                          name, column.size(), expected));
}

void check_finite(const char* name, const std::vector<double>& column, std::size_t width) {
  for (std::size_t k = 0; k < column.size(); ++k)
    if (!std::isfinite(column[k]))
      throw Error(
          fmt::format("frame: {} of item {} is not finite, so the frame cannot be drawn; draw an earlier one",
                      name, k / width));
}

}  // namespace

void check_columns(const Frame& frame) {
  if (frame.dimension != 2 && frame.dimension != 3)
    throw Error(fmt::format("frame: dimension is {}; it must be 2 or 3", frame.dimension));
  const std::size_t n = frame.particle_count();
  check_length("position", frame.position, 3 * n, false);
  check_length("id", frame.id, n, false);
  check_length("material", frame.material, n, true);
  check_length("coordination", frame.coordination, n, true);
  check_length("velocity", frame.velocity, 3 * n, true);
  check_length("spin", frame.spin, 3 * n, true);
  check_length("force", frame.force, 3 * n, true);
  check_length("displacement", frame.displacement, 3 * n, true);
  check_length("group", frame.group, n, true);
  const std::size_t c = frame.contact_count();
  check_length("contact_from", frame.contact_from, 3 * c, false);
  check_length("contact_to", frame.contact_to, 3 * c, false);
  check_length("contact_tangential_force", frame.contact_tangential_force, c, false);
  check_length("contact_overlap", frame.contact_overlap, c, false);
  check_length("contact_sliding", frame.contact_sliding, c, false);
  check_length("contact_a", frame.contact_a, c, true);
  check_length("contact_b", frame.contact_b, c, true);
  check_length("contact_wall", frame.contact_wall, c, true);
  check_length("contact_normal", frame.contact_normal, 3 * c, true);
  check_length("contact_force", frame.contact_force, 3 * c, true);
  check_length("contact_point", frame.contact_point, 3 * c, true);
  for (const Surface& surface : frame.surfaces) {
    const std::size_t corners = std::size_t(frame.dimension), points = surface.points.size() / 3;
    check_length("points of a surface", surface.points, 3 * points, false);
    check_length("cells of a surface", surface.cells, surface.cells.size() / corners * corners, false);
    for (const std::uint32_t point : surface.cells)
      if (point >= points)
        throw Error(fmt::format("frame: surface {} has a cell with point {} of {}; give indices of points",
                                surface.name, point, points));
  }
}

void check_drawable(const Frame& frame) {
  check_finite("position", frame.position, 3);
  check_finite("radius", frame.radius, 1);
  check_finite("contact_from", frame.contact_from, 3);
  check_finite("contact_to", frame.contact_to, 3);
  check_finite("contact_normal_force", frame.contact_normal_force, 1);
  for (const Surface& surface : frame.surfaces) check_finite("points of a surface", surface.points, 3);
}

}  // namespace scree::pictures
