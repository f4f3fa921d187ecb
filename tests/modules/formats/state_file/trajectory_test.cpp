#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/trajectory.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::state_file;
using Catch::Matchers::Contains;

namespace {

// Two bodies in 2D, in a box that is periodic along x and shrinks.
TrajectoryFrame frame(std::uint64_t number) {
  TrajectoryFrame frame;
  const double k = double(number);
  frame.time = 0.1 * k;
  frame.step = 10 * number;
  frame.dimension = 2;
  frame.periodic = {true, false, false};
  frame.edges = {2 - 0.1 * k, 0, 0};
  frame.fixed["id"] = {std::vector<std::int64_t>{4, 9}, {2}, ""};
  frame.fixed["radius"] = {std::vector<double>{0.1, 0.2}, {2}, "m"};
  frame.moving["position"] = {std::vector<double>{k, 0.3, k + 1, 0.4}, {2, 2}, "m"};
  frame.moving["spin"] = {std::vector<double>{0.5 * k, -k}, {2}, "rad/s"};
  frame.moving["image"] = {std::vector<std::int32_t>{int(number), 0, 0, 0}, {2, 2}, ""};
  return frame;
}

std::string file_of(const std::filesystem::path& path, std::uint64_t frames) {
  for (std::uint64_t k = 0; k < frames; ++k) append_frame(path, frame(k), k);
  return text_of(path);
}

}  // namespace

TEST_CASE("A trajectory that is cut has the bytes of one without the later frames", "[trajectory]") {
  const TemporaryFolder folder;
  const std::string three = file_of(folder / "three.h5md", 3), five = file_of(folder / "five.h5md", 5);
  CHECK(three != five);
  check_frames(folder / "five.h5md", 5);
  cut_frames(folder / "five.h5md", 3);
  CHECK(text_of(folder / "five.h5md") == three);
  for (std::uint64_t k = 3; k < 5; ++k) append_frame(folder / "five.h5md", frame(k), k);
  CHECK(text_of(folder / "five.h5md") == five);
}

TEST_CASE("A trajectory without the frames of a state, or without its file, is refused", "[trajectory]") {
  const TemporaryFolder folder;
  const auto file = folder / "a.h5md";
  const std::string whole = file_of(file, 2);
  CHECK_THROWS_WITH(check_frames(file, 3),
                    Contains("a.h5md: cannot be read (") &&
                        Contains("has fewer than 3 frames); put it back as the run wrote it"));
  CHECK_THROWS_AS(check_frames(folder / "none.h5md", 1), Error);
  folder.write("b.h5md", whole.substr(0, whole.size() / 2));
  CHECK_THROWS_WITH(check_frames(folder / "b.h5md", 2), Contains("is not a whole HDF5 file"));
  CHECK_THROWS_WITH(append_frame(folder / "missing/a.h5md", frame(0), 0), Contains("cannot be written ("));
}
