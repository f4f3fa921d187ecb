#include "refusals.hpp"
#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;
using Catch::Matchers::Contains;
using state_file::read_state;
using state_file::write_state;

TEST_CASE("A state that is read is the one that was written", "[state_file]") {
  const TemporaryFolder folder;
  State state = odd_state();
  write_state(folder / "a.h5", state);
  State read = read_state(folder / "a.h5");
  const auto bits = [](const State& of) {
    return __builtin_bit_cast(std::uint64_t, std::get<std::vector<double>>(of.at("odd/payload").values)[0]);
  };
  CHECK(bits(read) == bits(state));
  for (State* of : {&state, &read})
    of->put("odd/payload", {std::vector<double>{}, {0}, "1"});  // is not equal to itself
  CHECK(read == state);
}

TEST_CASE("A state without arrays, without bodies or without positions is kept", "[state_file]") {
  const TemporaryFolder folder;
  State none, empty, elsewhere;
  empty.put("bodies/position", {std::vector<double>{}, {0, 2}, "m"});
  empty.put("bodies/id", {std::vector<std::int64_t>{}, {0}, ""});
  elsewhere.put("bodies/velocity", {std::vector<double>{1, 2}, {1, 2}, "m/s"});
  elsewhere.put("bodies/position", {std::vector<float>{1, 2}, {1, 2}, "m"});
  for (const State& state : {none, empty, elsewhere}) {
    write_state(folder / "a.h5", state);
    CHECK(read_state(folder / "a.h5") == state);
  }
}

TEST_CASE("An array that a file could not hold is refused before anything is written", "[state_file]") {
  const TemporaryFolder folder;
  for (const char* path : {"", "/a", "a/", "a//b", "A", "a b", "a.b", "ä"}) {
    INFO(path);
    State state;
    state.put(path, {std::vector<double>{1}, {}, "m"});
    CHECK_THROWS_AS(write_state(folder / "a.h5", state), std::invalid_argument);
  }
  State both, shape;
  both.put("a", {std::vector<double>{1}, {}, "m"});
  both.put("a/b/c", {std::vector<double>{1}, {}, "m"});
  shape.put("a", {std::vector<double>{1}, {2}, "m"});
  CHECK_THROWS_WITH(write_state(folder / "a.h5", both), "the state has 'a/b/c' and 'a'");
  CHECK_THROWS_WITH(write_state(folder / "a.h5", shape), "'a' has 1 value in a shape of 2");
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("A state is not written where there is no folder or no permission", "[state_file]") {
  const TemporaryFolder folder;
  CHECK_THAT(failure(folder / "none/a.h5", sample_state()), Contains("No such file or directory"));
  CHECK_THAT(failure(folder.write("file", "") / "a.h5", sample_state()), Contains("Not a directory"));
  CHECK_THAT(failure("/proc/a.h5", sample_state()),
             Contains("; check that its folder exists and is writable"));
  std::filesystem::create_directory(folder / "a.h5");
  CHECK_THAT(failure(folder / "a.h5", sample_state()), Contains("Is a directory"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.h5.part"));
}

TEST_CASE("A link of the name of the part is replaced and not followed", "[state_file]") {
  const TemporaryFolder folder;
  const auto other = folder.write("other", "precious");
  std::filesystem::create_symlink(other, folder / "a.h5.part");
  write_state(folder / "a.h5", sample_state());
  CHECK(text_of(other) == "precious");
  CHECK(std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / "a.h5")));
  CHECK_FALSE(std::filesystem::exists(folder / "a.h5.part"));
}
