#include "scene/cut_frame.hpp"

#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

namespace {

Frame cut_along_x(const Frame& frame, double low, double high, ColorField& field) {
  return cut_frame(frame, half_spaces({std::array{low, high}, {}, {}}), field);
}

}  // namespace

TEST_CASE("a cut leaves the bodies that reach into its range, with their columns", "[pictures]") {
  const Frame frame = sample_frame();
  RenderOptions options;
  options.color_by = "id";
  const ColorField field = color_field(frame, options);
  ColorField of_all = field, of_half = field;
  CHECK(cut_along_x(frame, -2, 2, of_all).id == frame.id);
  const double low = frame.position[6] + 0.5 * frame.radius[2];  // this body is cut
  const Frame half = cut_along_x(frame, low, 2, of_half);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    if (frame.position[3 * i] + frame.radius[i] <= low) continue;
    REQUIRE(kept < half.particle_count());
    CHECK(half.id[kept] == frame.id[i]);
    CHECK(of_half.values[kept] == field.values[i]);
    CHECK(half.radius[kept] == frame.radius[i]);
    CHECK(half.velocity[3 * kept + 1] == frame.velocity[3 * i + 1]);
    CHECK(half.material[kept] == frame.material[i]);
    CHECK(half.displacement[3 * kept + 2] == frame.displacement[3 * i + 2]);
    CHECK(half.group[kept] == frame.group[i]);
    ++kept;
  }
  CHECK(kept == half.particle_count());
  CHECK(kept < frame.particle_count());
  CHECK(half.walls.size() == 2);
  ColorField none = field;
  CHECK(cut_along_x(frame, 7, 8, none).particle_count() == 0);
  CHECK(none.values.empty());
}

TEST_CASE("bars of contacts end where a cut does", "[pictures]") {
  Frame frame = sample_frame();
  frame.contact_from = {0, 0, 0, -1, 0, 0, -1, 0, 0, 0.5, 0, 0};
  frame.contact_to = {1, 2, 0, -0.5, 0, 0, 1, 0, 4, 0.5, 1, 0};
  ColorField field = color_field(frame, {});
  const Frame part = cut_along_x(frame, 0, 0.5, field);
  // The second lies outside, the third goes through both ends.
  CHECK(part.contact_from == std::vector<double>{0, 0, 0, 0, 0, 2, 0.5, 0, 0});
  CHECK(part.contact_to == std::vector<double>{0.5, 1, 0, 0.5, 0, 3, 0.5, 1, 0});
  CHECK(part.contact_force.size() == 9);
  CHECK(part.contact_a == std::vector<std::int64_t>{frame.id[0], frame.id[2], frame.id[3]});
}
