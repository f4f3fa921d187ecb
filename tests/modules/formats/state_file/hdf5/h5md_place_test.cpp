#include "hdf5/h5md_place.hpp"

#include <string>
#include <utility>

#include <catch2/catch.hpp>

using namespace scree::state_file;

TEST_CASE("Arrays of bodies have the names of H5MD, and frames if they change in a run", "[h5md_place]") {
  const std::pair<const char*, const char*> places[] = {
      {"bodies/position", "particles/bodies/position/value"},
      {"bodies/velocity", "particles/bodies/velocity/value"},
      {"bodies/radius", "particles/bodies/radius"},
      {"bodies/material", "particles/bodies/species"}};
  for (const auto& [path, dataset] : places) {
    REQUIRE(h5md_place(path));
    CHECK(h5md_place(path)->dataset() == dataset);
    CHECK(path_at(dataset) == path);
  }
}

TEST_CASE("Names that have another meaning in H5MD have no place there", "[h5md_place]") {
  for (const char* path : {"clock/time", "bodies/box", "bodies/species", "bodies/a/value"})
    CHECK_FALSE(h5md_place(path));
  // "radius" does not change, and "position" does.
  for (const char* dataset : {"particles/bodies/position", "particles/bodies/radius/value",
                              "particles/bodies/box", "particles/others/position/value"})
    CHECK_FALSE(path_at(dataset));
}
