#pragma once

#include "temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cairo.h>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <scree/charts/draw_chart.hpp>
#include <scree/error.hpp>

namespace scree::charts {

// The pixels of a PNG file.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> colors;  // 0xRRGGBB, rows from the top

  std::array<int, 3> at(int x, int y) const {
    const std::uint32_t color = colors[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    return {int(color >> 16 & 0xFF), int(color >> 8 & 0xFF), int(color & 0xFF)};
  }
};

inline Pixels decoded(const std::filesystem::path& png_file) {
  cairo_surface_t* surface = cairo_image_surface_create_from_png(png_file.c_str());
  Pixels pixels{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* row = cairo_image_surface_get_data(surface);
  for (int y = 0; y < pixels.height; ++y, row += cairo_image_surface_get_stride(surface)) {
    const auto* first = reinterpret_cast<const std::uint32_t*>(row);
    for (int x = 0; x < pixels.width; ++x) pixels.colors.push_back(first[x] & 0xFFFFFF);
  }
  cairo_surface_destroy(surface);
  return pixels;
}

inline Pixels drawn(const ChartSpec& spec) {
  const test::TemporaryFolder folder;
  draw_chart(spec, folder / "chart.png");
  return decoded(folder / "chart.png");
}

// The bytes of a chart in a format.
inline std::string file_of(const ChartSpec& spec, const std::string& format) {
  const test::TemporaryFolder folder;
  draw_chart(spec, folder / ("chart." + format));
  return test::text_of(folder / ("chart." + format));
}

inline bool is_near(const std::array<int, 3>& color, const std::array<int, 3>& wanted) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(color[k] - wanted[k]) > 30) return false;
  return true;
}

constexpr std::array<int, 3> red = {255, 0, 0};

// The inside of the frame around the curves: dark lines over at least half of the picture.
struct Plot {
  int left, top, right, bottom;

  static Plot of(const Pixels& picture) {
    const auto dark = [&](int x, int y) { return picture.at(x, y)[0] < 100 && picture.at(x, y)[1] < 100; };
    Plot plot{-1, -1, -1, -1};
    for (int x = 0; x < picture.width; ++x) {
      int count = 0;
      for (int y = 0; y < picture.height; ++y) count += dark(x, y);
      if (count > picture.height / 2) (plot.left < 0 ? plot.left : plot.right) = x;
    }
    for (int y = 0; y < picture.height; ++y) {
      int count = 0;
      for (int x = 0; x < picture.width; ++x) count += dark(x, y);
      if (count > picture.width / 3) (plot.top < 0 ? plot.top : plot.bottom) = y;
    }
    return plot;
  }
};

// Columns of the plot with a colour, the row from the top of its highest pixel in the leftmost and in the
// rightmost.
struct Trace {
  int columns = 0, first_row = -1, last_row = -1;
};

inline Trace trace(const Pixels& picture, const std::array<int, 3>& color) {
  const Plot plot = Plot::of(picture);
  Trace found;
  for (int x = plot.left + 1; x < plot.right; ++x)
    for (int y = plot.top + 1; y < plot.bottom; ++y) {
      if (!is_near(picture.at(x, y), color)) continue;
      if (found.first_row < 0) found.first_row = y;
      found.last_row = y;
      ++found.columns;
      break;
    }
  return found;
}

// A chart of one red curve.
inline ChartSpec spec_of(std::vector<double> x, std::vector<double> y) {
  ChartSpec spec;
  spec.title = "a chart";
  spec.x_label = "time (s)";
  spec.y_label = "energy (J)";
  spec.series.push_back(
      {"one", std::move(x), std::move(y), std::array<double, 3>{1, 0, 0}, LineStyle::solid, false});
  return spec;
}

}  // namespace scree::charts
