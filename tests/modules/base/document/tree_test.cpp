#include "document_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;

TEST_CASE("a value is named by its path in the notation of overrides, a table as it is written") {
  const Document document = Document::parse(
      "[time]\nsteps = { first = 'a' }\n[[contact]]\nfriction = 'b'\n[[contact]]\nfriction = 'c'\n"
      "[[wall]]\npoints = [[0, 'd']]\n[wall.load]\n",
      "scene.toml");
  const Table root = document.root();
  const auto named = [](const auto& read) {
    const std::string line = message(read);
    return line.substr(line.find(": ") + 2);
  };
  CHECK(named([&] {
          root.table("time").table("steps").number("first");
        }).starts_with("time.steps.first is a string"));
  CHECK(named([&] {
          root.tables("contact")[1].number("friction");
        }).starts_with("contact[1].friction is a string"));
  // The only entry of a list needs no index.
  CHECK(
      named([&] { root.tables("wall")[0].rows("points", 2); }).starts_with("wall.points[0][1] is a string"));
  CHECK(named([&] { root.table("time").number("step"); }).starts_with("[time] has no 'step'"));
  CHECK(named([&] { root.tables("contact")[0].number("mass"); }).starts_with("[[contact]] has no 'mass'"));
  CHECK(named([&] {
          root.tables("wall")[0].table("load").number("at");
        }).starts_with("[wall.load] has no 'at'"));
  CHECK(named([&] { root.number("seed"); }).starts_with("the file has no 'seed'"));
}

TEST_CASE("keys follow the order of the file, and then that of the overrides") {
  const Document document = Document::parse("z = 1\na = 2\n\nm = 3\n", "scene.toml", {"b=4", "a=5", "c=6"});
  CHECK(document.root().keys() == std::vector<std::string>{"z", "a", "m", "b", "c"});
}

TEST_CASE("places hold behind a byte order mark, CRLF ends, tabs and letters of several bytes") {
  const Table root = document_of("\xEF\xBB\xBFtop = 1\r\n\tnext = 2\r\nword = ['\xC3\xA9', 3]\r\n").root();
  CHECK(root.place("top") == "scene.toml:1:7");
  CHECK(root.place("next") == "scene.toml:2:9");
  CHECK(message([&] { root.strings("word"); }).starts_with("scene.toml:3:14: word[1] "));
}
