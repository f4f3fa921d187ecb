#include "sample_frame.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("a frame without its contacts file has no contacts", "[snapshot]") {
  const ScratchDirectory directory;
  backend().write_frame(sample_frame(), directory.path());
  std::filesystem::remove(directory / "contacts_0123456789.vtp");
  const Frame back = backend().read_frame(directory / particles_file);
  CHECK(back.contact_count() == 0);
  CHECK(back.particle_count() == 7);
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
