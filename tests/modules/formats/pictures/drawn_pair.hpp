#pragma once

#include "sample_frame.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include <catch2/catch.hpp>

// Pictures of two particles, and what is seen in them.

namespace scree::pictures {

using Rgb = std::array<std::uint8_t, 3>;

// Hues of the ends of the colour map, lit or in shade.
inline bool is_yellow(const Rgb& c) { return c[0] > 30 && c[0] >= c[1] && c[1] > 2 * c[2]; }
inline bool is_violet(const Rgb& c) { return c[2] > 15 && c[2] >= c[0] && c[0] > 2 * c[1]; }

// Pixels of the scene's panel that have a colour: how many, and their centre (pixels from the upper left).
struct Blob {
  int pixels = 0;
  double x = 0;
  double y = 0;
};

inline Blob find_blob(const Picture& picture, const std::function<bool(const Rgb&)>& matches) {
  Blob blob;
  for (int y = picture.height / 10; y < picture.height * 9 / 10; ++y)
    for (int x = 0; x < picture.width * 8 / 10; ++x)
      if (matches(picture.at(x, y))) {
        blob.pixels += 1;
        blob.x += x;
        blob.y += y;
      }
  blob.x /= blob.pixels;
  blob.y /= blob.pixels;
  return blob;
}

inline Frame pair(std::array<double, 3> violet, std::array<double, 3> yellow, int dimension) {
  Frame frame;
  frame.dimension = dimension;
  frame.title = "a pair";
  frame.id = {0, 1};
  frame.radius = {0.1, 0.1};
  frame.position = {violet[0], violet[1], violet[2], yellow[0], yellow[1], yellow[2]};
  frame.velocity = {0, 0, 0, 3, 0, dimension == 3 ? 4.0 : 0.0};
  frame.lower = {0, 0, 0};
  frame.upper = {1, 1, dimension == 3 ? 1.0 : 0.0};
  return frame;
}

inline Picture draw(const Frame& frame, const RenderOptions& options) {
  const ScratchDirectory directory;
  backend().render(frame, options, directory / "picture.png");
  return backend().read_png(directory / "picture.png");
}

inline RenderOptions by_speed(const std::string& view) {
  RenderOptions options;
  options.width = 800;
  options.height = 600;
  options.color_by = "speed";
  options.view = view;
  return options;
}

// Checks position and size of both particles. right, up: offset from the violet to the yellow one in the view
// of the unit box. The dark rim of a sphere does not count as coloured.
inline void check_pair(const Picture& picture, double right, double up) {
  const Blob violet = find_blob(picture, is_violet), yellow = find_blob(picture, is_yellow);
  REQUIRE(violet.pixels > 1000);
  const double shown_right = yellow.x - violet.x, shown_up = violet.y - yellow.y;
  const double pixels_per_metre = std::hypot(shown_right, shown_up) / std::hypot(right, up);
  CHECK(pixels_per_metre == Approx(500).epsilon(0.05));  // the box fills the panel
  CHECK(shown_right == Approx(pixels_per_metre * right).margin(2));
  CHECK(shown_up == Approx(pixels_per_metre * up).margin(2));
  const double disc = 3.14159265 * std::pow(0.1 * pixels_per_metre, 2);
  CHECK(violet.pixels == Approx(disc).epsilon(0.1));
  CHECK(yellow.pixels == Approx(disc).epsilon(0.1));
}

}  // namespace scree::pictures
