#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

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

// Calls use(body, contact) for both bodies of each contact; false if the frame does not say which they are.
template <class Use>
bool for_each_end(const Frame& frame, const Use& use) {
  if (frame.contact_a.size() != frame.contact_count()) return false;
  std::unordered_map<std::int64_t, std::size_t> bodies;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) bodies[frame.id[i]] = i;
  for (std::size_t c = 0; c < frame.contact_count(); ++c)
    for (const std::int64_t id : {frame.contact_a[c], frame.contact_b[c]})
      if (const auto found = bodies.find(id); found != bodies.end()) use(found->second, c);
  return true;
}

std::vector<double> largest_forces(const Frame& frame) {
  const std::vector<double> forces = magnitudes(frame.contact_force);
  std::vector<double> largest(frame.particle_count(), 0.0);
  const bool known = for_each_end(
      frame, [&](std::size_t body, std::size_t c) { largest[body] = std::max(largest[body], forces[c]); });
  return known ? largest : std::vector<double>();
}

// Mean normal stress of each body by Love and Weber, Σ_c f_n l/(D V), with the arms l to the middle of the
// overlap.
std::vector<double> pressures(const Frame& frame) {
  std::vector<double> pressure(frame.particle_count(), 0.0);
  const bool known = for_each_end(frame, [&](std::size_t body, std::size_t c) {
    const double r = frame.radius[body], pi = std::numbers::pi;
    const double volume = frame.dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r;
    pressure[body] += frame.contact_normal_force[c] * (r - 0.5 * frame.contact_overlap[c]) /
                      (double(frame.dimension) * volume);
  });
  return known ? pressure : std::vector<double>();
}

// Whether a height along an axis is so near to the bodies that a picture of it still shows these.
bool is_near(const Frame& frame, double height, std::size_t axis) {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < frame.particle_count(); ++i) {
      low[k] = std::min(low[k], frame.position[3 * i + k] - frame.radius[i]);
      high[k] = std::max(high[k], frame.position[3 * i + k] + frame.radius[i]);
    }
    extent = std::max(extent, high[k] - low[k]);
  }
  return frame.particle_count() == 0 || within_view(height, low[axis], high[axis], extent);
}

}  // namespace

std::vector<double> color_values(const Frame& frame, const std::string& color_by) {
  if (color_by == "radius") return frame.radius;
  if (color_by == "speed") return magnitudes(frame.velocity);
  if (color_by.starts_with("velocity_"))
    return components(frame.velocity, std::size_t(color_by.back() - 'x'));
  if (color_by == "material") return {frame.material.begin(), frame.material.end()};
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
  for (std::size_t k = 0; k < std::size_t(frame.dimension); ++k) {
    if (frame.lower[k] < frame.upper[k]) add_extent(k, frame.lower[k], frame.upper[k]);
    for (std::size_t i = 0; i < frame.particle_count(); ++i)
      add_extent(k, frame.position[3 * i + k] - frame.radius[i], frame.position[3 * i + k] + frame.radius[i]);
    for (const Wall& wall : frame.walls)
      if (std::abs(wall.normal[k]) > 0.999 && is_near(frame, wall.point[k], k))
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
