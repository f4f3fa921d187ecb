#include "sample_frame.hpp"

#include <functional>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

using Rgb = std::array<std::uint8_t, 3>;

// Hues of the ends of the colour map, lit or in shade.
bool is_yellow(const Rgb& c) { return c[0] > 30 && c[0] >= c[1] && c[1] > 2 * c[2]; }
bool is_violet(const Rgb& c) { return c[2] > 15 && c[2] >= c[0] && c[0] > 2 * c[1]; }

// Pixels of the scene's panel that have a colour: how many, and their centre (pixels from the upper left).
struct Blob {
  int pixels = 0;
  double x = 0;
  double y = 0;
};

Blob find_blob(const Picture& picture, const std::function<bool(const Rgb&)>& matches) {
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

Frame pair(std::array<double, 3> violet, std::array<double, 3> yellow, int dimension) {
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

Picture draw(const Frame& frame, const RenderOptions& options) {
  const ScratchDirectory directory;
  backend().render(frame, options, directory / "picture.png");
  return backend().read_png(directory / "picture.png");
}

RenderOptions by_speed(const std::string& view) {
  RenderOptions options;
  options.width = 800;
  options.height = 600;
  options.color_by = "speed";
  options.view = view;
  return options;
}

// Checks position and size of both particles. right, up: offset from the violet to the yellow one in the view
// of the unit box. The dark rim of a sphere does not count as coloured.
void check_pair(const Picture& picture, double right, double up) {
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

}  // namespace

TEST_CASE("discs appear with their colours and positions", "[snapshot]") {
  check_pair(draw(pair({0.2, 0.3, 0}, {0.7, 0.7, 0}, 2), by_speed("")), 0.5, 0.4);
}

TEST_CASE("spheres appear with their colours and positions in every view", "[snapshot]") {
  const Frame frame = pair({0.2, 0.3, 0.4}, {0.7, 0.7, 0.6}, 3);
  check_pair(draw(frame, by_speed("x")), 0.4, 0.2);
  check_pair(draw(frame, by_speed("y")), 0.5, 0.2);
  check_pair(draw(frame, by_speed("z")), 0.5, 0.4);
}

TEST_CASE("the nearer sphere hides the farther one", "[snapshot]") {
  const Picture picture = draw(pair({0.5, 0.5, 0.8}, {0.5, 0.5, 0.2}, 3), by_speed("z"));
  CHECK(find_blob(picture, is_violet).pixels > 1000);
  CHECK(find_blob(picture, is_yellow).pixels == 0);
}

TEST_CASE("walls are visible without hiding the spheres", "[snapshot]") {
  Frame frame = pair({0.2, 0.3, 0.4}, {0.7, 0.8, 0.6}, 3);
  for (int k = 0; k < 3; ++k)
    for (double side : {0.0, 1.0}) {
      Wall wall{"wall", {side, side, side}, {}};
      wall.normal[k] = 1 - 2 * side;
      frame.walls.push_back(wall);
    }
  const auto is_wall = [](const Rgb& c) { return c[0] < 245 && c[0] > 210 && c[2] > c[0]; };
  RenderOptions options = by_speed("iso");
  const Picture with_walls = draw(frame, options);
  options.show_walls = false;
  const Picture without_walls = draw(frame, options);
  CHECK(find_blob(with_walls, is_wall).pixels > 50000);
  CHECK(find_blob(without_walls, is_wall).pixels < 500);
  CHECK(find_blob(with_walls, is_yellow).pixels > 0.9 * find_blob(without_walls, is_yellow).pixels);
}

TEST_CASE("contacts are drawn from end to end, sliding ones in red", "[snapshot]") {
  Frame frame = pair({0.2, 0.5, 0}, {0.8, 0.5, 0}, 2);
  frame.contact_from = {0.2, 0.5, 0};
  frame.contact_to = {0.8, 0.5, 0};
  frame.contact_normal_force = {5};
  frame.contact_tangential_force = {1};
  frame.contact_overlap = {1e-6};
  frame.contact_sliding = {1};
  const auto is_red = [](const Rgb& c) { return c[0] > 180 && c[1] < 80 && c[2] < 80; };
  RenderOptions options = by_speed("");
  const Picture without = draw(frame, options);
  CHECK(find_blob(without, is_red).pixels == 0);
  const Blob violet = find_blob(without, is_violet), yellow = find_blob(without, is_yellow);
  options.show_contacts = true;
  const Picture picture = draw(frame, options);
  const Blob bar = find_blob(picture, is_red);
  CHECK(find_blob(picture, is_violet).pixels == 0);  // discs are pale, so that bars stand out
  CHECK(bar.pixels > 1000);
  CHECK(bar.x == Approx((violet.x + yellow.x) / 2).margin(8));
}

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

TEST_CASE("arrows begin at the centres, in the colours of their lengths", "[snapshot]") {
  const Frame frame = pair({0.2, 0.5, 0}, {0.6, 0.5, 0}, 2);
  const ScratchDirectory directory;
  // The first points up, and is too short to be seen; the second points right.
  const ArrowField arrows = {
      .vectors = {0, 1e-3, 0, 5, 0, 0}, .longest = 0.3, .title = "share", .note = "arrows"};
  backend().render_arrows(frame, arrows, {}, directory / "arrows.png");
  const Picture picture = backend().read_png(directory / "arrows.png");
  const Blob yellow = find_blob(picture, is_yellow), violet = find_blob(picture, is_violet);
  CHECK(violet.pixels == 0);
  REQUIRE(yellow.pixels > 300);
  // Its middle is right of the centre of its body, which is right of the middle of the scene.
  const Blob bodies =
      find_blob(picture, [](const Rgb& c) { return c[0] > 190 && c[0] < 220 && c[0] == c[2]; });
  REQUIRE(bodies.pixels > 300);
  CHECK(yellow.x > bodies.x + 50);
  const ArrowField one = {.vectors = {1, 0, 0}, .longest = 1, .title = "", .note = ""};
  CHECK_THROWS_WITH(backend().render_arrows(frame, one, {}, directory / "x.png"),
                    Contains("give one for each"));
}

TEST_CASE("the time of a picture is shown as exactly as the spacing of pictures asks", "[snapshot]") {
  RenderOptions options;
  options.width = 400, options.height = 300;
  const auto at = [&](double time, double spacing) {
    Frame frame = pair({0.3, 0.5, 0.5}, {0.7, 0.5, 0.5}, 2);
    frame.time = time;
    options.time_spacing = spacing;
    return draw(frame, options).rgb;
  };
  CHECK(at(0.0999984, 0.1) == at(0.1, 0));
  CHECK(at(0.0999984, 1e-5) != at(0.1, 0));
  CHECK(at(0.0999984, 0) != at(0.1, 0));
  CHECK(at(12.3456, 0.25) == at(12.346, 0));
  CHECK(at(0, 0.1) == at(0, 0));
}
