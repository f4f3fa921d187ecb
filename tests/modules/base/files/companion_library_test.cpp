#include <catch2/catch.hpp>

#include <scree/files/companion_library.hpp>

using namespace scree;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

TEST_CASE("a library that did not come with the program is named, with what to do without it",
          "[companion_library]") {
  const files::CompanionLibrary library = {"scree_none", "make", "pictures", "leave them out", "a package"};
  CHECK_THROWS_WITH(
      files::load_companion<int>(library, 1),
      EndsWith(
          "/lib/libscree_none.so: not found; it is required for pictures: build the target scree_none, or "
          "leave them out"));
}
