#include "scene/cut_frame.hpp"

#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("a cut leaves the bodies in its range with their columns, and contacts between them",
          "[pictures]") {
  const Frame frame = sample_frame();
  // Every body, and then those whose x is above 0.
  CHECK(cut_frame(frame, {std::array{-2.0, 2.0}, {}, {}}).id == frame.id);
  const Frame half = cut_frame(frame, {std::array{0.0, 2.0}, {}, {}});
  std::size_t kept = 0;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    if (frame.position[3 * i] < 0) continue;
    REQUIRE(kept < half.particle_count());
    CHECK(half.id[kept] == frame.id[i]);
    CHECK(half.radius[kept] == frame.radius[i]);
    CHECK(half.velocity[3 * kept + 1] == frame.velocity[3 * i + 1]);
    CHECK(half.material[kept] == frame.material[i]);
    ++kept;
  }
  CHECK(kept == half.particle_count());
  CHECK(kept < frame.particle_count());
  std::size_t contacts = 0;
  for (std::size_t c = 0; c < frame.contact_count(); ++c)
    contacts += frame.contact_from[3 * c] >= 0 && frame.contact_to[3 * c] >= 0;
  CHECK(half.contact_count() == contacts);
  CHECK(half.contact_force.size() == 3 * contacts);
  CHECK(half.walls.size() == 2);
  CHECK_THAT(error_of([&] {
               cut_frame(frame, {std::array{7.0, 8.0}, {}, {}});
             }),
             Catch::Contains("none of 7 bodies lies there"));
}
