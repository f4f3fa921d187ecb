#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <scree/pictures/frame.hpp>
#include <scree/pictures/render_options.hpp>

namespace scree::pictures {

// Colour of the viridis map, perceptually uniform; t in 0..1, clamped; grey for NaN.
std::array<std::uint8_t, 3> viridis(double t);

// Colours that differ at a glance, also to the colour-blind; they repeat after as many.
inline constexpr std::array<std::array<std::uint8_t, 3>, 8> group_colors = {{{0, 114, 178},
                                                                             {230, 159, 0},
                                                                             {0, 158, 115},
                                                                             {213, 94, 0},
                                                                             {86, 180, 233},
                                                                             {204, 121, 167},
                                                                             {240, 228, 66},
                                                                             {90, 60, 160}}};

// One value per particle and its colour map.
struct ColorField {
  std::string title;  // with the unit of values, lower and upper
  std::vector<double> values;
  double lower;
  double upper;
  bool whole_numbers;
  double paleness = 0;  // share of white in the colours, 0 to 1
  // If there are a few values only: each of them, for a legend in place of the bar.
  std::vector<double> distinct{};
  // If values are indices into names, or -1 for none: the names, each with a colour of its own.
  std::vector<std::string> names{};

  // Colour at a share of the range, 0 to 1.
  std::array<std::uint8_t, 3> color_at(double share) const;
  std::array<std::uint8_t, 3> color_of(double value) const;
  std::array<std::uint8_t, 3> color(std::size_t particle) const { return color_of(values[particle]); }

  struct Entry {
    std::array<std::uint8_t, 3> color;
    std::string label;
  };
  // Empty if a bar shows the colours.
  std::vector<Entry> legend() const;
};

// Throws scree::Error for an unknown field or one that is absent from the frame.
ColorField color_field(const Frame& frame, const RenderOptions& options);

}  // namespace scree::pictures
