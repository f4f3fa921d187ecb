#include "scene/ambient_occlusion.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;

namespace {

constexpr int field_size = 80;
constexpr double ball = 20;  // (pixels)

// Mean over the rows, whose chords differ, of the shares in a column and its neighbour.
double share_in(int column, const std::function<double(int x)>& depth) {
  DepthField field = {field_size, field_size};
  for (int y = 0; y < field_size; ++y)
    for (int x = 0; x < field_size; ++x) field.depth.push_back(float(depth(x)));
  const std::vector<float> shares = open_shares(field, ball);
  double sum = 0;
  for (int y = 0; y < field_size; ++y)
    for (const int x : {column, column + 1}) sum += double(shares[std::size_t(y * field_size + x)]);
  return sum / (2 * field_size);
}

}  // namespace

TEST_CASE("planes and edges are open, and what is drawn nowhere takes no light", "[pictures]") {
  CHECK(share_in(40, [](int) { return 3.0; }) == 1);
  CHECK(share_in(40, [](int x) { return 0.5 * x; }) == Approx(1).margin(1e-6));  // of round-off
  CHECK(share_in(40, [](int x) { return x < 45 ? 0.0 : -15.0; }) == 1);
  CHECK(share_in(40, [](int x) { return x < 45 ? 0.0 : -double(INFINITY); }) == 1);
  CHECK(share_in(60, [](int x) { return x < 45 ? 0.0 : -double(INFINITY); }) == 1);
}

// A step as high as the ball takes the upper half of the cap that lies beyond it at the distance d:
// 1 - (R - d)^2 (2 R + d)/(4 R^3). 256 chords at random would give it to 0.04.
TEST_CASE("the light beside a step is the free part of a ball", "[pictures]") {
  for (const int distance : {1, 5, 10}) {
    const double d = distance / ball;
    const double expected = 1 - (1 - d) * (1 - d) * (2 + d) / 4;
    const double share = share_in(39 - distance, [](int x) { return x < 40 ? 0.0 : ball; });
    CHECK(share == Approx(expected).margin(0.04));
  }
  // What stands far before the surface is something else.
  CHECK(share_in(35, [](int x) { return x < 40 ? 0.0 : 4 * ball; }) == 1);
}
