#include "opened_file.hpp"
#include "resealed.hpp"
#include "sample_state.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"

#include <array>

#include <catch2/catch.hpp>

#include <scree/contact_list.hpp>
#include <scree/error.hpp>
#include <scree/state_file/description.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;
using Catch::Matchers::Contains;

TEST_CASE("The description of a state file tells what it is and lists its arrays", "[description]") {
  const TemporaryFolder folder;
  State state = sample_state();
  state.put("scene/law_plugins", {std::vector<std::string>{"hertz_mindlin"}, {1}, ""});
  state.put("run/scenario", {std::vector(1, std::string(1000, 'x')), {}, ""});
  const auto file = folder / "a.h5";
  state_file::write_state(file, state);
  const std::string text = state_file::describe_state_file(file);
  CHECK(text.starts_with(file.string() + ": state written by scree " SCREE_TEST_VERSION ", format 2, " +
                         std::to_string(std::filesystem::file_size(file)) + " bytes, checksum "));
  CHECK_THAT(text,
             Contains("\ntime         0.1 s\nsteps        18446744073709551615\nbodies       3 in 3D\n"));
  CHECK_THAT(text, Contains("\nmaterials    glass, Größe 石 \U0001FAA8, \nlaws         hertz_mindlin\n"));
  CHECK_THAT(
      text,
      Contains(
          "\n  particles/bodies/position/value  double  1 x 3 x 3     m                   72 bytes  0, 1, 2"));
  CHECK_THAT(
      text,
      Contains(
          "\n  scree/clock/time                 double  single        s                    8 bytes  0.1\n"));
  CHECK_THAT(
      text,
      Contains("\n  scree/run/scenario               text    single                          1000 bytes\n"));
}

// The names of the arrays that make the summary are those of the kernel.
TEST_CASE("The description of a simulation has all lines of the summary", "[description]") {
  const TemporaryFolder folder;
  Scene scene = test::scene(2, 0.5, {body(1, 1, 1, {}, {}, {}, 2)},
                            {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
  add_boundary(scene, "plane", {{"point", {0, -2, 0}}, {"normal", {0, 1, 0}}});
  Simulation simulation(scene);
  simulation.step();
  const auto file = folder / "a.h5";
  state_file::write_state(file, simulation.state());
  CHECK_THAT(
      state_file::describe_state_file(file),
      Contains("\ntime         0.5 s\nsteps        1\nbodies       1 in 2D\nmaterials    grain\n"
               "laws         linear_spring_dashpot\nwalls        plane\nintegrator   velocity_verlet\n"));
}

// As the notes of the description say.
TEST_CASE("The notes on contacts lead from a row of forces to its pair", "[description]") {
  const TemporaryFolder folder;
  Scene scene = test::scene(2, 1e-3,
                            {body(1, 1, 1, {}, {}, {}, 2), body(2, 1, 1, {{1.95, 0, 0}}, {}, {}, 2),
                             body(3, 1, 1, {{3.88, 0, 0}}, {}, {}, 2)},
                            {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
  add_boundary(scene, "plane", {{"point", {0, -0.95, 0}}, {"normal", {0, 1, 0}}});
  const Simulation simulation(scene);
  const State state = simulation.state();
  state_file::write_state(folder / "a.h5", state);
  const std::string text = state_file::describe_state_file(folder / "a.h5");
  CHECK_THAT(text, Contains("force_row[k], counted from 0 through the groups 0, 1, ...,\n") &&
                       Contains("filled up to a multiple of 8 pairs"));
  const auto numbers = [&](const std::string& path) {
    return std::get<std::vector<std::uint32_t>>(state.at("contacts/" + path).values);
  };
  std::vector<std::array<std::uint32_t, 2>> pairs;  // of bodies, with walls behind the bodies
  for (const std::string group : {"0", "1"}) {
    const auto a = numbers(group + "/a"), b = numbers(group + "/b");
    for (std::size_t k = 0; k < a.size(); ++k) pairs.push_back({a[k], b[k] + (group == "1" ? 3 : 0)});
    pairs.resize((pairs.size() + 7) / 8 * 8);
  }
  const auto rows = numbers("force_row");
  const auto force = std::get<std::vector<double>>(state.at("contacts/force").values);
  const ContactList list = simulation.contact_list();
  REQUIRE(list.size() == 5);
  REQUIRE(rows.size() == 5);
  for (std::size_t c = 0; c < 5; ++c)
    for (std::size_t k = 0; k < 5; ++k)
      if (pairs.at(rows[k]) == std::array{list.a[c], list.b[c]}) {
        CHECK(force[2 * k] == list.force[3 * c]);
        CHECK(force[2 * k + 1] == list.force[3 * c + 1]);
        pairs[rows[k]] = {};
      }
  for (const std::uint32_t row : rows) CHECK(pairs[row] == std::array<std::uint32_t, 2>{});
}

TEST_CASE("What is written of texts and units in a description is printable", "[description]") {
  const TemporaryFolder folder;
  State state;
  state.put("scene/materials", {std::vector<std::string>{"a\nb\x1b[2J"}, {1}, "m\n\x1b"});
  state_file::write_state(folder / "a.h5", state);
  const std::string text = state_file::describe_state_file(folder / "a.h5");
  CHECK_THAT(text, Contains("a\\nb\\x1B[2J"));
  CHECK(text.find('\x1b') == text.npos);
}

TEST_CASE("The version in a seal is printable in a description", "[description]") {
  const TemporaryFolder folder;
  state_file::write_state(folder / "a.h5", sample_state());
  const auto file = folder.write(
      "b.h5", resealed(text_of(folder / "a.h5"), {.program_version = "0\x1b[2J\t" + std::string(200, 'x')}));
  const std::string text = state_file::describe_state_file(file);
  CHECK_THAT(text, Contains("state written by scree 0\\x1B[2J\\txxx"));
  CHECK(text.find('\x1b') == text.npos);
}

TEST_CASE("A file that is removed while it is read is said to have been removed", "[description]") {
  const TemporaryFolder folder;
  const auto file = folder / "a.h5";
  state_file::write_state(file, sample_state());
  const state_file::OpenedFile opened(file);
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(opened.state(),
                    file.string() + ": was removed while it was read; give a file that stays");
  state_file::write_state(file, sample_state());
  const state_file::OpenedFile replaced(file);
  state_file::write_state(file, odd_state());
  CHECK_THROWS_WITH(replaced.state(), Contains(": was removed while it was read; "));
}

TEST_CASE("A damaged file is not described", "[description]") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(state_file::describe_state_file(folder.write("a.h5", "scree state\n")), Error);
}
