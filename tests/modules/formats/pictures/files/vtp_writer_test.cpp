#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("files contain the names of the arrays and binary data", "[snapshot]") {
  const ScratchDirectory directory;
  backend().write_frame(sample_frame(), directory.path());
  const std::string particles = read_text(directory / particles_file);
  for (const char* name : {"id", "material", "radius", "velocity", "spin", "coordination", "force", "stress",
                           "displacement", "group", "group_name", "TimeValue"})
    CHECK_THAT(particles, Contains("Name=\"" + std::string(name) + "\""));
  CHECK_THAT(particles, Contains("type=\"PolyData\"") && Contains("encoding=\"base64\""));
  const std::string contacts = read_text(directory / "contacts_0123456789.vtp");
  for (const char* name : {"normal_force", "tangential_force", "overlap", "sliding", "body_a", "body_b",
                           "wall", "normal", "force", "point", "wall_name"})
    CHECK_THAT(contacts, Contains("Name=\"" + std::string(name) + "\""));
  CHECK_THAT(contacts, Contains("NumberOfLines=\"4\""));
}

TEST_CASE("an output path that cannot be written is named", "[snapshot]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "file") << "in the way";
  CHECK_THAT(error_of([&] { backend().write_frame(sample_frame(), directory / "file/snapshots"); }),
             Contains("file/snapshots") && Contains("cannot be opened for writing; check that its folder"));
  CHECK_THAT(error_of([&] { backend().write_frame(sample_frame(), "/proc/snapshots"); }),
             Contains("cannot be opened for writing"));
}

TEST_CASE("a failed write leaves nothing behind", "[snapshot]") {
  const ScratchDirectory directory;
  std::filesystem::create_directory(directory / particles_file);  // the rename onto a directory fails
  CHECK_THAT(error_of([&] { backend().write_frame(sample_frame(), directory.path()); }),
             Contains(particles_file));
  for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
    CHECK_THAT(entry.path().filename().string(), !Contains(".part"));
}

TEST_CASE("a file of surfaces keeps their shapes, loads and maps", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  Surface square, slab;
  square.name = "square", slab.name = "a \"slab\"";
  square.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  square.cells = {0, 1, 2, 0, 2, 3};
  slab.points = {0, 0, 2, 1, 0, 2, 1, 1, 2};
  slab.cells = {0, 1, 2};
  square.force = {0.1, -0.2, 0.3}, square.torque = {1 / 3.0, 0, -1};
  square.normal_stress = {1 / 7.0, 2 / 7.0}, slab.normal_stress = {-1e200};
  square.shear_stress = {1 / 9.0, 2 / 9.0}, slab.shear_stress = {0};
  square.traction = {1, 2, 3, 4, 5, 6.1}, slab.traction = {7, 8, 9};
  frame.surfaces = {square, slab};
  backend().write_frame(frame, directory.path());
  const Frame read = backend().read_frame(directory / particles_file);
  REQUIRE(read.surfaces.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const Surface &a = frame.surfaces[k], &b = read.surfaces[k];
    CHECK(b.name == a.name);
    CHECK(b.force == a.force);
    CHECK(b.torque == a.torque);
    REQUIRE(b.cells.size() == a.cells.size());
    for (std::size_t c = 0; c < a.cells.size(); ++c)
      for (std::size_t i = 0; i < 3; ++i) CHECK(b.points[3 * b.cells[c] + i] == a.points[3 * a.cells[c] + i]);
    CHECK(b.normal_stress == a.normal_stress);
    CHECK(b.shear_stress == a.shear_stress);
    CHECK(b.traction == a.traction);
    CHECK(b.sliding_work.empty());
  }
  CHECK_THAT(read_text(directory / "surfaces_0123456789.vtp"), !Contains("sliding_work"));
  frame.surfaces[0].sliding_work = {0.25, 0.5}, frame.surfaces[1].sliding_work = {0.75};
  frame.step = 7;
  backend().write_frame(frame, directory.path());
  const Frame with_work = backend().read_frame(directory / "particles_0000000007.vtp");
  CHECK(with_work.surfaces[0].sliding_work == frame.surfaces[0].sliding_work);
  CHECK(with_work.surfaces[1].sliding_work == frame.surfaces[1].sliding_work);
}
