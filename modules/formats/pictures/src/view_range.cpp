#include "body_stress.hpp"

#include <algorithm>
#include <cmath>

#include <scree/pictures/view_range.hpp>

namespace scree::pictures {

namespace {

std::vector<double> magnitudes(const std::vector<double>& vectors) {
  std::vector<double> values(vectors.size() / 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = std::hypot(vectors[3 * k], vectors[3 * k + 1], vectors[3 * k + 2]);
  return values;
}

std::vector<double> components(const std::vector<double>& vectors, std::size_t axis) {
  std::vector<double> values(vectors.size() / 3);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = vectors[3 * k + axis];
  return values;
}

// The ends of the bodies of a frame along each axis (m), and their largest extent.
struct BodiesBox {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  double extent = INFINITY;  // without bodies every wall is near

  explicit BodiesBox(const Frame& frame) {
    for (std::size_t i = 0; i < frame.particle_count(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], frame.position[3 * i + k] - frame.radius[i]);
        high[k] = std::max(high[k], frame.position[3 * i + k] + frame.radius[i]);
      }
    if (frame.particle_count() > 0) extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }
  bool is_near(double height, std::size_t axis) const {
    return std::isinf(extent) || within_view(height, low[axis], high[axis], extent);
  }
};

}  // namespace

std::vector<double> color_values(const Frame& frame, const std::string& color_by) {
  if (color_by == "radius") return frame.radius;
  if (color_by == "speed") return magnitudes(frame.velocity);
  if (color_by == "displacement") return magnitudes(frame.displacement);
  if (color_by.starts_with("velocity_") || color_by.starts_with("displacement_"))
    return components(color_by[0] == 'v' ? frame.velocity : frame.displacement,
                      std::size_t(color_by.back() - 'x'));
  if (color_by == "material") return {frame.material.begin(), frame.material.end()};
  if (color_by == "group") return {frame.group.begin(), frame.group.end()};
  if (color_by == "spin") return magnitudes(frame.spin);
  if (color_by == "net_force") return magnitudes(frame.force);
  if (color_by == "largest_force") return largest_forces(frame);
  if (color_by == "pressure") return pressures(frame);
  if (color_by == "coordination") return {frame.coordination.begin(), frame.coordination.end()};
  return {frame.id.begin(), frame.id.end()};
}

void ViewRange::add_colors(const Frame& frame) {
  for (const double value : color_values(frame, color_by_))
    if (std::isfinite(value)) extend_colors({value, value});
}

void ViewRange::extend_colors(const std::array<double, 2>& extent) {
  if (!colors_) colors_ = extent;
  colors_ = {std::min((*colors_)[0], extent[0]), std::max((*colors_)[1], extent[1])};
}

void ViewRange::add_box(const Frame& frame) {
  const BodiesBox bodies(frame);
  for (std::size_t k = 0; k < std::size_t(frame.dimension); ++k) {
    if (frame.lower[k] < frame.upper[k]) add_extent(k, frame.lower[k], frame.upper[k]);
    for (std::size_t i = 0; i < frame.particle_count(); ++i)
      add_extent(k, frame.position[3 * i + k] - frame.radius[i], frame.position[3 * i + k] + frame.radius[i]);
    for (const Wall& wall : frame.walls)
      if (std::abs(wall.normal[k]) > 0.999 && bodies.is_near(wall.point[k], k))
        add_extent(k, wall.point[k], wall.point[k]);
  }
}

void ViewRange::add_extent(std::size_t axis, double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return;
  lower_[axis] = empty_[axis] ? low : std::min(lower_[axis], low);
  upper_[axis] = empty_[axis] ? high : std::max(upper_[axis], high);
  empty_[axis] = false;
}

std::optional<std::array<double, 2>> ViewRange::colors() const {
  return colors_ && (*colors_)[0] < (*colors_)[1] ? colors_ : std::nullopt;
}

}  // namespace scree::pictures
