#include "drawn_pair.hpp"

#include <functional>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

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
