#include "sample_frame.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

struct Entry {
  double time;
  std::string file;
  bool operator==(const Entry&) const = default;
};

// Value of the next attribute at or after `position`, which is set behind it.
std::string attribute(const std::string& text, const std::string& name, std::size_t& position) {
  const std::size_t begin = text.find(name + "=\"", position) + name.size() + 2;
  position = text.find('"', begin);
  return text.substr(begin, position - begin);
}

std::vector<Entry> entries(const std::filesystem::path& pvd_file) {
  const std::string text = read_text(pvd_file);
  std::vector<Entry> found;
  for (std::size_t position = 0; (position = text.find("<DataSet ", position)) != std::string::npos;) {
    const double time = std::stod(attribute(text, "timestep", position));
    found.push_back({time, attribute(text, "file", position)});
  }
  return found;
}

void write(std::uint64_t step, double time, const ScratchDirectory& directory) {
  Frame frame = sample_frame();
  frame.step = step;
  frame.time = time;
  backend().write_frame(frame, directory.path());
}

}  // namespace

TEST_CASE("the index lists every frame in order of time", "[snapshot]") {
  const ScratchDirectory directory;
  write(0, 0, directory);
  write(900, 0.1 + 0.2, directory);
  write(300, 1.0 / 3e3, directory);
  const std::vector<Entry> wanted = {{0, "particles_0000000000.vtp"},
                                     {1.0 / 3e3, "particles_0000000300.vtp"},
                                     {0.1 + 0.2, "particles_0000000900.vtp"}};
  CHECK(entries(directory / "particles.pvd") == wanted);
  CHECK(entries(directory / "contacts.pvd").size() == 3);
  CHECK_THAT(read_text(directory / "particles.pvd"),
             Contains("type=\"Collection\"") && Contains("</VTKFile>"));
}

TEST_CASE("a resumed run continues the index and replaces frames it repeats", "[snapshot]") {
  const ScratchDirectory directory;
  write(1, 0.1, directory);
  write(2, 0.2, directory);
  const auto resumed = load_backend();
  Frame frame = sample_frame();
  for (std::uint64_t step : {2, 3}) {
    frame.step = step;
    frame.time = 0.1 * double(step);
    resumed->write_frame(frame, directory.path());
  }
  const auto listed = entries(directory / "particles.pvd");
  REQUIRE(listed.size() == 3);
  CHECK(listed[0].file == "particles_0000000001.vtp");
  CHECK(listed[1].file == "particles_0000000002.vtp");
  CHECK(listed[2].file == "particles_0000000003.vtp");
}

TEST_CASE("the index drops frames whose files are gone", "[snapshot]") {
  const ScratchDirectory directory;
  write(1, 0.1, directory);
  write(2, 0.2, directory);
  std::filesystem::remove(directory / "particles_0000000001.vtp");
  write(3, 0.3, directory);
  const auto listed = entries(directory / "particles.pvd");
  REQUIRE(listed.size() == 2);
  CHECK(listed[0].file == "particles_0000000002.vtp");
}

TEST_CASE("a damaged index is refused, not overwritten", "[snapshot]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "particles.pvd") << "precious notes";
  CHECK_THAT(error_of([&] { write(1, 0.1, directory); }),
             Contains("particles.pvd") && Contains("move it away"));
  CHECK(read_text(directory / "particles.pvd") == "precious notes");
}
