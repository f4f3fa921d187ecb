#include <catch2/catch.hpp>

#include <scree/files/place_error.hpp>

using namespace scree;
using namespace scree::files;

TEST_CASE("an error of a place has one cure for those who can leave it and one for those who cannot",
          "[files]") {
  const PlaceError curable("out", "is not a file", "remove it");
  CHECK(curable.what() == std::string("out: is not a file; remove it, or give another --out"));
  CHECK(curable.in_place().what() == std::string("out: is not a file; remove it"));
  const PlaceError hopeless("out", "cannot be written", "");
  CHECK(hopeless.what() == std::string("out: cannot be written; give another --out"));
  CHECK(hopeless.in_place().what() == std::string("out: cannot be written; check its permissions"));
  const PlaceError failure = hopeless.with_status(ExitStatus::failure);
  CHECK(failure.status() == ExitStatus::failure);
  CHECK(failure.in_place().what() == std::string(hopeless.in_place().what()));
}

TEST_CASE("work in a place that stays reports the cure for the place, with the status of the error",
          "[files]") {
  CHECK(in_place([] { return 3; }) == 3);
  try {
    in_place([]() -> int { throw PlaceError("x", "is full", "free disk space", ExitStatus::failure); });
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.what() == std::string("x: is full; free disk space"));
    CHECK(error.status() == ExitStatus::failure);
  }
  CHECK_THROWS_WITH(in_place([]() -> int { throw Error("other; cure"); }), "other; cure");
}

TEST_CASE("the record of work that went on in its place names the cure for the place", "[files]") {
  const PlaceError full("x", "is full", "free disk space");
  CHECK(record_line(full, true) == "x: is full; free disk space");
  CHECK(record_line(full, false) == "x: is full; free disk space, or give another --out");
  CHECK(record_line(Error("other; cure"), true) == "other; cure");
}

TEST_CASE("an error after something was written is no bad input, and keeps its cures", "[files]") {
  const auto rethrown = [](const auto& error) {
    try {
      try {
        throw error;
      } catch (const Error& caught) {
        rethrow_as_failure(caught);
      }
    } catch (const PlaceError& place) {
      return std::pair(place.status(), std::string(place.in_place().what()));
    } catch (const Error& other) {
      return std::pair(other.status(), std::string(other.what()));
    }
  };
  CHECK(rethrown(Error("a; b")) == std::pair(ExitStatus::failure, std::string("a; b")));
  CHECK(rethrown(Error("a; b", ExitStatus::blow_up)) == std::pair(ExitStatus::blow_up, std::string("a; b")));
  CHECK(rethrown(PlaceError("p", "a", "b")) == std::pair(ExitStatus::failure, std::string("p: a; b")));
}
