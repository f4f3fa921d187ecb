#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <scree/snapshot/frame.hpp>
#include <scree/snapshot/render_options.hpp>

namespace scree::snapshot {

// Colour of the viridis map, perceptually uniform; t in 0..1, clamped; grey for NaN.
std::array<std::uint8_t, 3> viridis(double t);

// A number with an SI prefix that makes it readable, for example {1e3, "mm"}.
struct ScaledUnit {
  double factor;  // by which to multiply SI values
  std::string symbol;
};
ScaledUnit scaled_unit(double largest, const std::string& unit);

// One number per particle and how it is coloured.
struct ColorField {
  std::string title;  // with the unit of values, lower and upper
  std::vector<double> values;
  double lower;
  double upper;
  bool whole_numbers;

  std::array<std::uint8_t, 3> color(std::size_t particle) const {
    return viridis((values[particle] - lower) / (upper - lower));
  }
};

// Throws scree::Error for an unknown field or one that the frame does not carry.
ColorField color_field(const Frame& frame, const RenderOptions& options);

}  // namespace scree::snapshot
