#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

constexpr const char* particles_file = "particles_0123456789.vtp";

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
  CHECK(a.contact_from == b.contact_from);
  CHECK(a.contact_to == b.contact_to);
  CHECK(a.contact_normal_force == b.contact_normal_force);
  CHECK(a.contact_tangential_force == b.contact_tangential_force);
  CHECK(a.contact_overlap == b.contact_overlap);
  CHECK(a.contact_sliding == b.contact_sliding);
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

TEST_CASE("columns that a scene lacks are omitted from the file", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  frame.dimension = 2;
  frame.spin.clear();
  frame.material.clear();
  backend().write_frame(frame, directory.path());
  check_equal(frame, backend().read_frame(directory / particles_file));
  CHECK_THAT(read_text(directory / particles_file), !Contains("\"spin\"") && Contains("\"velocity\""));
}

TEST_CASE("an empty frame is written and read", "[snapshot]") {
  const ScratchDirectory directory;
  const Frame empty;
  backend().write_frame(empty, directory.path());
  check_equal(empty, backend().read_frame(directory / "particles_0000000000.vtp"));
}

TEST_CASE("a frame without its contacts file has no contacts", "[snapshot]") {
  const ScratchDirectory directory;
  backend().write_frame(sample_frame(), directory.path());
  std::filesystem::remove(directory / "contacts_0123456789.vtp");
  const Frame back = backend().read_frame(directory / particles_file);
  CHECK(back.contact_count() == 0);
  CHECK(back.particle_count() == 7);
}

TEST_CASE("files contain the names of the arrays and binary data", "[snapshot]") {
  const ScratchDirectory directory;
  backend().write_frame(sample_frame(), directory.path());
  const std::string particles = read_text(directory / particles_file);
  for (const char* name :
       {"id", "material", "radius", "velocity", "spin", "coordination", "force", "TimeValue"})
    CHECK_THAT(particles, Contains("Name=\"" + std::string(name) + "\""));
  CHECK_THAT(particles, Contains("type=\"PolyData\"") && Contains("encoding=\"base64\""));
  const std::string contacts = read_text(directory / "contacts_0123456789.vtp");
  for (const char* name : {"normal_force", "tangential_force", "overlap", "sliding"})
    CHECK_THAT(contacts, Contains("Name=\"" + std::string(name) + "\""));
  CHECK_THAT(contacts, Contains("NumberOfLines=\"4\""));
}

TEST_CASE("files that are not frames are refused by name", "[snapshot]") {
  const ScratchDirectory directory;
  const auto refusal = [&](const std::string& name) {
    return error_of([&] { backend().read_frame(directory / name); });
  };
  CHECK_THAT(refusal("absent.vtp"), Contains("absent.vtp") && Contains("no such file"));
  std::ofstream(directory / "text.vtp") << "radius 1\n";
  CHECK_THAT(refusal("text.vtp"), Contains("text.vtp") && Contains("not a VTK XML PolyData file"));
  backend().write_frame(sample_frame(), directory.path());
  const std::string whole = read_text(directory / particles_file);
  std::ofstream(directory / "particles_cut.vtp") << whole.substr(0, whole.size() * 2 / 3);
  CHECK_THAT(refusal("particles_cut.vtp"), Contains("particles_cut.vtp") && Contains("damaged"));
}

TEST_CASE("attributes that crash or hang the reader of VTK are refused as damage", "[snapshot]") {
  const ScratchDirectory directory;
  backend().write_frame(sample_frame(), directory.path());
  const std::string whole = read_text(directory / particles_file);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
    std::ofstream(directory / "particles_1.vtp") << text;
    return error_of([&] { backend().read_frame(directory / "particles_1.vtp"); });
  };
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\"UInt64\" Name=\"step\"", "\"UInt65\" Name=\"step\""},
        {"NumberOfPoints=\"7\" ", "NumberOfPoints=\"-1\""},
        {"\"Float64\" Name=\"radius\"", "\"String\" Name=\"radius\""},
        {"\"spin\" NumberOfComponents=\"3\"", "\"spin\" NumberOfComponents=\"4000000000\""}}) {
    INFO(to);
    CHECK_THAT(refusal(from, to), Contains("particles_1.vtp: ") && Contains("; give a particles_<step>.vtp"));
  }
  CHECK(backend().read_frame(directory / particles_file).particle_count() == 7);  // as before
}

TEST_CASE("a frame with columns of different length is refused and leaves no file", "[snapshot]") {
  const ScratchDirectory directory;
  Frame frame = sample_frame();
  frame.velocity.pop_back();
  CHECK_THAT(error_of([&] { backend().write_frame(frame, directory.path()); }),
             Contains("column velocity has 20 values instead of 21"));
  CHECK(std::filesystem::is_empty(directory.path()));
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
