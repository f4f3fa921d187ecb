#pragma once

#include <array>
#include <optional>
#include <string>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// What pictures of several frames have in common: the box that they show and the range of their colours.
class ViewRange {
 public:
  // `color_by`: one of color_fields.
  explicit ViewRange(std::string color_by) : color_by_(std::move(color_by)) {}

  // Add the box, the particles and the axis-parallel walls of a frame; the values of its particles.
  void add_box(const Frame& frame);
  void add_colors(const Frame& frame);

  const std::array<double, 3>& lower() const { return lower_; }  // (m)
  const std::array<double, 3>& upper() const { return upper_; }  // (m)
  // (SI unit of the field); absent without finite values or if all are equal.
  std::optional<std::array<double, 2>> colors() const;
  // The same, also if all are equal.
  const std::optional<std::array<double, 2>>& color_extent() const { return colors_; }
  void extend_colors(const std::array<double, 2>& extent);

 private:
  void add_extent(std::size_t axis, double low, double high);

  std::string color_by_;
  std::array<bool, 3> empty_ = {true, true, true};
  std::array<double, 3> lower_{}, upper_{};
  std::optional<std::array<double, 2>> colors_;
};

// Whether a wall at a height (m) is near enough to bodies between `low` and `high`, whose largest extent is
// given, that a picture with both still shows the bodies: at most three extents away.
inline bool within_view(double height, double low, double high, double extent) {
  constexpr double reach = 3;
  return height >= low - reach * extent && height <= high + reach * extent;
}

// Values of a field, one of color_fields, vectors by magnitude (SI). Empty if the frame lacks it.
std::vector<double> color_values(const Frame& frame, const std::string& color_by);

}  // namespace scree::pictures
