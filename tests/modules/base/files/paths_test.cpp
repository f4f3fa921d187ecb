#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/files/paths.hpp>

namespace fs = std::filesystem;
using namespace scree::files;

TEST_CASE("a path is named from a folder, so that both can be moved", "[paths]") {
  const fs::path here = fs::current_path();
  CHECK(relative_to("results", "runs/a/series/box.csv") == "../runs/a/series/box.csv");
  CHECK(relative_to("", here / "box.csv") == "box.csv");
  CHECK(relative_to("a/../b", "b/./c") == "c");
}

TEST_CASE("a path is resolved as far as it exists", "[paths]") {
  const fs::path here = fs::canonical(fs::current_path());
  CHECK(resolved("") / "a" == here / "a");
  CHECK(resolved("missing/../other/x") == here / "other/x");
}
