#include "document_support.hpp"

#include <catch2/catch.hpp>

#include <scree/scenario/table_keys.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

struct DoorKeys : TableKeys {
  DoorKeys() : TableKeys("door", "[door]", "a door") {}
  NumberKey width = number("width", Range::positive("m"), "how wide");
  NumberKey angle = number("angle", Range::between(0, 90, "deg"), 45, "how far it is open");
  IntegerKey hinges = integer("hinges", Range::at_least(1), 2, "how many");
  BooleanKey locked = boolean("locked", false, "whether it is locked");
  StringKey colour = string("colour", "grey", "of the front", "as the wall");
  ChoiceKey wood = choice_or_first("wood", {"oak", "ash"}, "of the frame");
  ChoiceKey side = choice("side", {"left", "right"}, "of the hinges");
  Key place = other("place", "[x, y]", Range::any("m"), "optional", "of its middle");
};

const DoorKeys keys;

}  // namespace

TEST_CASE("a key is read with the range and the fallback with which it is declared", "[scenario]") {
  const document::Document document =
      document_of("[a]\nwidth = 2\nside = 'left'\n[b]\nwidth = -2\nangle = 91\n");
  const document::Table a = document.root().table("a"), b = document.root().table("b");
  CHECK(read(a, keys.width) == 2);
  CHECK(read(a, keys.angle) == 45);
  CHECK(read(a, keys.hinges) == 2);
  CHECK(read(a, keys.locked) == false);
  CHECK(read(a, keys.colour) == "grey");
  CHECK(read(a, keys.wood) == "oak");
  CHECK(read(a, keys.side) == "left");
  CHECK(read_optional(a, keys.width) == 2);
  CHECK_FALSE(read_optional(a, keys.angle));
  CHECK(message([&] { read(b, keys.width); }) ==
        "scene.toml:5:9: b.width = -2 m is negative; give a width above 0");
  CHECK(message([&] {
          read_optional(b, keys.angle);
        }).starts_with("scene.toml:6:9: b.angle = 91 deg is above 90 deg"));
  CHECK(message([&] { read(b, keys.side); }).starts_with("scene.toml:4:1: [b] has no 'side'"));
}

TEST_CASE("a key is described as it is read, in the order of declaration", "[scenario]") {
  struct Line {
    const char *name, *value, *absent;
  };
  const Line lines[] = {{"width", "number (m) above 0", "required"},
                        {"angle", "number from 0 to 90 deg", "default 45"},
                        {"hinges", "whole number of 1 or more", "default 2"},
                        {"locked", "true or false", "default false"},
                        {"colour", "text", "as the wall"},
                        {"wood", "\"oak\", \"ash\"", "default \"oak\""},
                        {"side", "\"left\", \"right\"", "required"},
                        {"place", "[x, y] (m)", "optional"}};
  const TableDescription& found = keys.description();
  CHECK(found.header == "[door]");
  REQUIRE(found.keys.size() == std::size(lines));
  for (std::size_t k = 0; k < found.keys.size(); ++k) {
    CHECK(found.keys[k].name == lines[k].name);
    CHECK(found.keys[k].value == lines[k].value);
    CHECK(found.keys[k].absent == lines[k].absent);
  }
}
