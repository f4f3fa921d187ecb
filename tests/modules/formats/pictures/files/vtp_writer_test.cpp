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
