#include "opened_file.hpp"
#include "resealed.hpp"
#include "sample_state.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

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
  CHECK_THAT(text,
             Contains("\n  bodies/position     double  3 x 3         m                   72 bytes  0, 1, 2"));
  CHECK_THAT(text,
             Contains("\n  clock/time          double  single        s                    8 bytes  0.1\n"));
  CHECK_THAT(text, Contains("\n  run/scenario        text    single                          1000 bytes\n"));
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
