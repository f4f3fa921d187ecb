#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

void check_equal(const Frame& a, const Frame& b) {
  CHECK(a.time == b.time);
  CHECK(a.step == b.step);
  CHECK(a.dimension == b.dimension);
  CHECK(a.title == b.title);
  CHECK(a.id == b.id);
  CHECK(a.radius == b.radius);
  CHECK(a.position == b.position);
  CHECK(a.material == b.material);
  CHECK(a.coordination == b.coordination);
  CHECK(a.velocity == b.velocity);
  CHECK(a.spin == b.spin);
  CHECK(a.force == b.force);
  CHECK(a.displacement == b.displacement);
  CHECK(a.group == b.group);
  CHECK(a.groups == b.groups);
  CHECK(a.contact_from == b.contact_from);
  CHECK(a.contact_to == b.contact_to);
  CHECK(a.contact_normal_force == b.contact_normal_force);
  CHECK(a.contact_tangential_force == b.contact_tangential_force);
  CHECK(a.contact_overlap == b.contact_overlap);
  CHECK(a.contact_sliding == b.contact_sliding);
  CHECK(a.contact_a == b.contact_a);
  CHECK(a.contact_b == b.contact_b);
  CHECK(a.contact_wall == b.contact_wall);
  CHECK(a.contact_normal == b.contact_normal);
  CHECK(a.contact_force == b.contact_force);
  CHECK(a.contact_point == b.contact_point);
  CHECK(a.lower == b.lower);
  CHECK(a.upper == b.upper);
  REQUIRE(a.walls.size() == b.walls.size());
  for (std::size_t k = 0; k < a.walls.size(); ++k) {
    CHECK(a.walls[k].name == b.walls[k].name);
    CHECK(a.walls[k].point == b.walls[k].point);
    CHECK(a.walls[k].normal == b.walls[k].normal);
  }
}

}  // namespace

TEST_CASE("a frame comes back from its files with the same bits", "[snapshot]") {
  const ScratchDirectory directory;
  const Frame frame = sample_frame();
  backend().write_frame(frame, directory / "new");
  const Frame back = backend().read_frame(directory / "new" / particles_file);
  check_equal(frame, back);
  CHECK(std::signbit(back.force[0]));
  // A directory of results that was removed is not made anew.
  CHECK_THROWS_AS(backend().write_frame(frame, directory / "removed/snapshots"), scree::Error);
  CHECK_FALSE(std::filesystem::exists(directory / "removed"));
}

TEST_CASE("an empty frame is written and read", "[snapshot]") {
  const ScratchDirectory directory;
  const Frame empty;
  backend().write_frame(empty, directory.path());
  check_equal(empty, backend().read_frame(directory / "particles_0000000000.vtp"));
}

TEST_CASE("a frame with the contact columns of earlier versions is written and read", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  frame.contact_a.clear(), frame.contact_b.clear(), frame.contact_wall.clear();
  frame.contact_normal.clear(), frame.contact_force.clear(), frame.contact_point.clear();
  backend().write_frame(frame, directory.path());
  check_equal(frame, backend().read_frame(directory / particles_file));
}

TEST_CASE("columns that a scene lacks are omitted from the file", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  frame.dimension = 2;
  frame.spin.clear();
  frame.material.clear();
  frame.displacement.clear(), frame.group.clear(), frame.groups.clear();
  backend().write_frame(frame, directory.path());
  check_equal(frame, backend().read_frame(directory / particles_file));
  CHECK_THAT(read_text(directory / particles_file), !Contains("\"spin\"") && !Contains("\"displacement\"") &&
                                                        !Contains("group") && Contains("\"velocity\""));
}
