#include "drawn_pair.hpp"

#include <functional>
#include <limits>
#include <set>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

// One body in the middle of the unit box.
Frame single(int dimension) {
  Frame frame = pair({0.5, 0.5, dimension == 3 ? 0.5 : 0.0}, {}, dimension);
  frame.id.pop_back(), frame.radius.pop_back();
  frame.position.resize(3), frame.velocity.resize(3);
  return frame;
}

}  // namespace

TEST_CASE("frames without particles or with equal ones are drawn", "[snapshot]") {
  const auto is_ink = [](const Rgb& c) { return c[0] < 250; };
  CHECK(find_blob(draw(Frame{}, {}), is_ink).pixels == 0);
  for (const char* field : {"radius", "speed", "id"}) {
    RenderOptions options;
    options.color_by = field;
    CHECK(find_blob(draw(pair({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 3), options), is_ink).pixels > 1000);
  }
}

TEST_CASE("pictures that cannot be drawn are refused", "[snapshot]") {
  const ScratchDirectory directory;
  const auto refusal = [&](const Frame& frame, const RenderOptions& options) {
    return error_of([&] { backend().render(frame, options, directory / "picture.png"); });
  };
  const Frame frame = pair({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 3);
  RenderOptions options;
  options.color_by = "sped";
  CHECK_THAT(refusal(frame, options), Contains("\"sped\"") && Contains("speed"));
  options.color_by = "spin";
  CHECK_THAT(refusal(frame, options), Contains("has no spin"));
  CHECK_THAT(refusal(frame, by_speed("top")), Contains("\"top\"") && Contains("iso"));
  options = {};
  options.color_range = {2, 1};
  CHECK_THAT(refusal(frame, options), Contains("color_range"));
  options = {};
  options.width = 20;
  CHECK_THAT(refusal(frame, options), Contains("20 x 900"));
  Frame broken = frame;
  broken.position[4] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(broken, {}), Contains("position of item 1"));
  CHECK(std::filesystem::is_empty(directory.path()));
}

TEST_CASE("title, time and scale bar are drawn as the options say", "[snapshot]") {
  const Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  const auto ink = [](const Picture& picture, int left, int right, int top, int bottom) {
    int pixels = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) pixels += picture.at(x, y)[0] < 100;
    return pixels;
  };
  RenderOptions options = by_speed("");
  const Picture usual = draw(frame, options);
  CHECK(ink(usual, 0, 400, 0, 50) > 50);
  CHECK(ink(usual, 600, 800, 0, 50) > 50);
  CHECK(ink(usual, 0, 250, 530, 600) == 0);
  options.show_title = options.show_time = false;
  options.scale_bar = true;
  const Picture bare = draw(frame, options);
  CHECK(ink(bare, 0, 400, 0, 50) == 0);
  CHECK(ink(bare, 600, 800, 0, 40) == 0);
  CHECK(ink(bare, 0, 250, 530, 600) > 50);
}

TEST_CASE("the frame can follow the bodies, cut the scene and look along any direction", "[snapshot]") {
  Frame frame = pair({0.4, 0.4, 0.5}, {0.6, 0.6, 0.5}, 3);
  RenderOptions options = by_speed("z");
  const int whole = find_blob(draw(frame, options), is_violet).pixels;
  options.follow_bodies = true;
  CHECK(find_blob(draw(frame, options), is_violet).pixels > 3 * whole);
  options = by_speed("");
  options.direction = {0, 0, 5};
  const Picture above = draw(frame, options);
  const Blob violet = find_blob(above, is_violet), yellow = find_blob(above, is_yellow);
  CHECK(yellow.x - violet.x == Approx(violet.y - yellow.y).margin(2));  // as along z
  options.direction = {0, 0, 0};
  CHECK_THAT(error_of([&] { draw(frame, options); }), Contains("has no length"));
  options = by_speed("z");
  options.cut[0] = {0.5, 1.0};
  options.color_range = {0.0, 5.0};
  CHECK(find_blob(draw(frame, options), is_violet).pixels == 0);
  CHECK(find_blob(draw(frame, options), is_yellow).pixels > 100);
}

// A plane at the distance d from the centre of a sphere leaves a disc of radius sqrt(R^2 - d^2). From the
// side that was cut off nothing else is seen if that was more than half, and the whole circle if it was less.
TEST_CASE("bodies are cut at a plane and closed there", "[snapshot]") {
  const Frame frame = single(3);
  const auto shown = [&](int axis, double low, double high, double towards) {
    RenderOptions options = by_speed("");
    options.direction = std::array{0.0, 0.0, 0.0};
    (*options.direction)[std::size_t(axis)] = towards;
    options.cut[std::size_t(axis)] = {low, high};
    return find_blob(draw(frame, options), [](const Rgb& c) { return c[0] < 250 && c[1] < 250; }).pixels;
  };
  const double whole = shown(2, 0, 1, 1);
  // 0.6 of the radius: 1 - 0.6^2 of the area. The circle has a rim of 150 pixels length.
  CHECK(shown(0, 0, 0.44, 1) == Approx(0.64 * whole).margin(50));
  CHECK(shown(2, 0.56, 1, -1) == Approx(0.64 * whole).margin(50));
  CHECK(shown(2, 0.44, 1, 1) == Approx(whole).margin(50));
  // From the side: the circle without a segment of 0.4 R height, acos(0.6) - 0.6 * 0.8 over pi.
  RenderOptions options = by_speed("z");
  options.cut[0] = {0.44, 1};
  const auto is_ink = [](const Rgb& c) { return c[0] < 250 && c[1] < 250; };
  const double segment = (std::acos(0.6) - 0.48) / 3.14159265;
  CHECK(find_blob(draw(frame, options), is_ink).pixels == Approx((1 - segment) * whole).margin(50));
  // In 2D the same of a disc, which has a rim around it.
  const double whole_disc = find_blob(draw(single(2), by_speed("")), is_ink).pixels;
  CHECK(find_blob(draw(single(2), options), is_ink).pixels == Approx((1 - segment) * whole_disc).margin(50));
}

TEST_CASE("a face of a cut is flat, and its edge dark", "[snapshot]") {
  const Frame frame = single(3);
  RenderOptions options = by_speed("z");
  options.color_range = {0, 5};
  const auto colors = [&] {
    std::set<Rgb> all;
    const Picture picture = draw(frame, options);
    const Blob blob = find_blob(picture, [](const Rgb& c) { return c[2] < 250; });
    for (int k = -30; k <= 30; ++k) all.insert(picture.at(int(blob.x) + k, int(blob.y)));
    return all;
  };
  CHECK(colors().size() > 10);
  options.cut[2] = {0, 0.5};
  CHECK(colors().size() == 1);
}

TEST_CASE("shadows darken what lies between other bodies, and nothing else", "[snapshot]") {
  Frame frame;
  frame.position = {0.4, 0.4, 0.6, 0.6, 0.4, 0.6, 0.4, 0.6, 0.6, 0.6, 0.6, 0.6, 0.5, 0.5, 0.46};
  frame.radius.assign(5, 0.1);
  frame.id = {1, 2, 3, 4, 5};
  frame.lower = {0, 0, 0}, frame.upper = {1, 1, 1};
  RenderOptions options;
  options.width = 800, options.height = 600;
  options.view = "z";
  options.scale_bar = true;
  const Picture usual = draw(frame, options);
  options.shadows = true;
  const Picture shaded = draw(frame, options);
  const Blob all = find_blob(usual, [](const Rgb& c) { return c[0] < 200; });
  const auto brightness = [](const Rgb& c) { return c[0] + c[1] + c[2]; };
  const int x = int(all.x), y = int(all.y);
  CHECK(brightness(shaded.at(x, y)) < 0.8 * brightness(usual.at(x, y)));
  CHECK(shaded.at(x - 70, y - 70) == usual.at(x - 70, y - 70));  // on a corner of the four
  for (const int column : {20, 60, 700, 750})                    // scale bar, colour bar
    for (int row = 0; row < usual.height; ++row)
      if (shaded.at(column, row) != usual.at(column, row)) FAIL(column << ' ' << row);
}

// The right half of a sphere, in a box from the cut to a margin of 3 % of its diagonal beyond the sphere: its
// centroid, 4 R/3π = 0.42 R from the cut, is 0.13 R left of the middle. With the whole sphere in the box it
// is 0.42 R right of it.
TEST_CASE("a frame that follows bodies ends where they are cut", "[snapshot]") {
  const auto is_ink = [](const Rgb& c) { return c[0] < 250 && c[1] < 250; };
  RenderOptions options = by_speed("z");
  options.follow_bodies = true;
  const Blob whole = find_blob(draw(single(3), options), is_ink);
  options.cut[0] = {0.5, 1};
  const Blob half = find_blob(draw(single(3), options), is_ink);
  REQUIRE(half.pixels > 1000);
  const double radius = std::sqrt(2 * half.pixels / 3.14159265);
  CHECK(std::abs(half.x - whole.x) < 0.2 * radius);
}
