#include "opened_file.hpp"

#include <csignal>
#include <functional>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::state_file;
using Catch::Matchers::Equals;

namespace {

// Stands for HDF5.
struct Backend final : StateBackend {
  std::function<std::vector<PlacedArray>()> work;

  explicit Backend(std::function<std::vector<PlacedArray>()> w) : work(std::move(w)) {}
  void write(const std::filesystem::path&, const State&) override {}
  std::vector<PlacedArray> places(const std::filesystem::path&) override { return work(); }
  void append_frame(const std::filesystem::path&, const TrajectoryFrame&, std::uint64_t) override {}
  void check_frames(const std::filesystem::path&, std::uint64_t) override {}
  TrajectoryFrame frame(const std::filesystem::path&, std::uint64_t) override { return {}; }
};

std::string refusal_of_backend(std::function<std::vector<PlacedArray>()> work) {
  Backend backend(std::move(work));
  try {
    places_in(0, backend);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("Where HDF5 crashes or ends the program, the file is damaged", "[opened_file]") {
  using Places = std::vector<PlacedArray>;
  CHECK_THAT(refusal_of_backend([] { return std::raise(SIGKILL), Places(); }),
             Equals("is damaged, so that HDF5 cannot read it (signal 9, Killed)"));
  CHECK_THAT(refusal_of_backend([]() -> Places { ::_exit(0); }),
             Equals("is damaged, so that HDF5 cannot read it (status 0)"));
  CHECK_THAT(refusal_of_backend([]() -> Places { throw Error("is odd"); }), Equals("is odd"));
}

TEST_CASE("Places that HDF5 finds are passed on as they are", "[opened_file]") {
  const PlacedArray large = {"a/b", 5, "m", {2, 3}, ~0ull, 8, {}}, texts = {"c", 0, "", {}, 512, 3, {1, 2}};
  Backend backend([&] { return std::vector{large, texts}; });
  const std::vector<PlacedArray> found = places_in(0, backend);
  REQUIRE(found.size() == 2);
  CHECK(found[0] == large);
  CHECK(found[1] == texts);
  Backend none([] { return std::vector<PlacedArray>(); });
  CHECK(places_in(0, none).empty());
}
