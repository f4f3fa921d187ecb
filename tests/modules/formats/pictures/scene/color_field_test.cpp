#include "scene/color_field.hpp"

#include "drawn_pair.hpp"

#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("the colour map goes from violet to yellow, and a missing value is grey", "[pictures]") {
  CHECK(viridis(0) == Rgb{68, 1, 84});
  CHECK(viridis(0.5) == Rgb{33, 144, 141});
  CHECK(viridis(1) == Rgb{253, 231, 37});
  CHECK(viridis(-3) == viridis(0));
  CHECK(viridis(7) == viridis(1));
  CHECK(viridis(std::numeric_limits<double>::quiet_NaN()) == Rgb{160, 160, 160});
  // In the middle between two of its knots: (68 + 71)/2, (1 + 44)/2, (84 + 122)/2, rounded.
  CHECK(viridis(1.0 / 16) == Rgb{70, 23, 103});
}

TEST_CASE("the values of a field have a unit in which they are short", "[pictures]") {
  const Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);  // radii 0.1 m, speeds 0 and 3 m/s
  RenderOptions options;
  options.color_by = "speed";
  const ColorField speed = color_field(frame, options);
  CHECK(speed.title == "speed (m/s)");
  CHECK(speed.values == std::vector<double>{0, 3});
  CHECK(speed.lower == 0);
  CHECK(speed.upper == 3);
  CHECK(speed.color(1) == viridis(1));
  options.color_range = {0, 6e-3};
  const ColorField slow = color_field(frame, options);
  CHECK(slow.title == "speed (mm/s)");
  CHECK(slow.upper == Approx(6));
  CHECK(slow.values[1] == Approx(3000));
}

TEST_CASE("equal values are in the middle of their colours", "[pictures]") {
  const Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  RenderOptions options;
  options.color_by = "radius";
  const ColorField radius = color_field(frame, options);
  CHECK(radius.lower < radius.values[0]);
  CHECK(radius.upper > radius.values[0]);
  Frame still = frame;
  still.velocity.assign(6, 0.0);
  options.color_by = "speed";
  CHECK(color_field(still, options).upper == 1);  // of 0 the range is 0 to 1
}

TEST_CASE("discs among contacts are paler, so that contacts are seen", "[pictures]") {
  RenderOptions options;
  options.color_by = "speed";
  const Frame discs = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2), spheres = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 3);
  options.show_contacts = true;
  // 0.6 of the way to white.
  CHECK(color_field(discs, options).color(0) == Rgb{180, 153, 187});
  CHECK(color_field(spheres, options).color(0) == viridis(0));
}

TEST_CASE("a field that is unknown or not in the frame is refused", "[pictures]") {
  const Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  const auto refusal = [&](const std::string& field) {
    RenderOptions options;
    options.color_by = field;
    return error_of([&] { color_field(frame, options); });
  };
  CHECK_THAT(refusal("sped"), Contains("unknown field \"sped\"; choose one of radius, speed"));
  CHECK_THAT(refusal("net_force"), Contains("this scene has no net_force; "));
}

TEST_CASE("a few radii or materials have a legend, many values a bar", "[pictures]") {
  Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  CHECK(color_field(frame, {}).distinct.empty());  // of one radius
  frame.radius = {0.1, 0.2};
  CHECK(color_field(frame, {}).distinct == std::vector<double>{0.1, 0.2});
  frame.material = {3, 1};
  RenderOptions options;
  options.color_by = "material";
  CHECK(color_field(frame, options).distinct == std::vector<double>{1, 3});
  frame.material = {3, 3};
  CHECK(color_field(frame, options).distinct == std::vector<double>{3});
  options.color_by = "velocity_x";
  const ColorField velocity = color_field(frame, options);
  CHECK(velocity.values == std::vector<double>{0, 3});
  CHECK(velocity.distinct.empty());
}

TEST_CASE("displacements are shown by length and by component", "[pictures]") {
  Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  RenderOptions options;
  options.color_by = "displacement";
  CHECK_THAT(
      error_of([&] { color_field(frame, options); }),
      Contains("these snapshots have no displacement; run the scene with color_by = \"displacement\""));
  frame.displacement = {0.003, -0.004, 0, 0, 0.001, 0};
  const ColorField length = color_field(frame, options);
  CHECK(length.title == "displacement (mm)");
  CHECK(length.values[0] == Approx(5));
  CHECK(length.values[1] == Approx(1));
  options.color_by = "displacement_y";
  CHECK(color_field(frame, options).values[0] == Approx(-4));
}

TEST_CASE("groups have a colour each and a legend, and bodies in none are grey", "[pictures]") {
  Frame frame = pair({0.2, 0.2, 0}, {0.8, 0.8, 0}, 2);
  RenderOptions options;
  options.color_by = "group";
  CHECK_THAT(error_of([&] { color_field(frame, options); }), Contains("these snapshots have no group; "));
  frame.groups = {"floor", "lid"};
  frame.group = {1, -1};
  options.color_range = {3, 4};  // that of other quantities has no meaning here
  const ColorField groups = color_field(frame, options);
  CHECK(groups.color(0) == group_colors[1]);
  CHECK(groups.color(1) == Rgb{160, 160, 160});
  const std::vector<ColorField::Entry> legend = groups.legend();
  REQUIRE(legend.size() == 3);
  CHECK(legend[0].color == group_colors[0]);
  CHECK(legend[0].label == "floor");
  CHECK(legend[1].label == "lid");
  CHECK(legend[2].label == "in no group");
  frame.group = {1, 0};
  CHECK(color_field(frame, options).legend().size() == 2);
  frame.group = {2, 0};
  CHECK_THAT(error_of([&] { color_field(frame, options); }), Contains("a group that has no name"));
}
