#include "document_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;

TEST_CASE("an unknown key is refused with the nearest and all known keys") {
  const Document document =
      document_of("[time]\nstep = 1\n\n[[contact]]\nplugin = 'p'\n\nfrction = 0.5\nzzz = 1\n");
  const Table root = document.root();
  root.table("time").number("step");
  const Table contact = root.tables("contact").front();
  contact.string("plugin");
  contact.number("friction", 0.0);
  const std::string line =
      "scene.toml:7:1: unknown key 'frction' in [[contact]]; did you mean 'friction'? known keys: plugin, "
      "friction";
  CHECK(message([&] { document.refuse_unused(); }) == line);
  CHECK(message([&] { contact.refuse_unused(); }) == line);
  CHECK_NOTHROW(root.table("time").refuse_unused());
  CHECK(contact.has("frction"));
  CHECK(contact.is_number("frction"));
  CHECK(contact.place("frction") == "scene.toml:7:11");
  CHECK(message([&] { document.refuse_unused(); }) == line);
  CHECK(contact.optional("frction"));
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:8:1: unknown key 'zzz' in [[contact]]; known keys: plugin, friction, frction");
  contact.accept("zzz");
  CHECK_NOTHROW(document.refuse_unused());
}

TEST_CASE("the first unknown key in file order is the one refused") {
  const Document document = document_of("[b]\nx = 1\n[a]\ny = 2\n[b.inner]\nz = 3\n");
  document.root().table("a");
  const Table b = document.root().table("b");
  b.table("inner");
  CHECK(message([&] { document.refuse_unused(); }).starts_with("scene.toml:2:1: unknown key 'x' in [b]; "));
  b.number("x");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:4:1: unknown key 'y' in [a]; remove it, no key is read here");
  document.root().accept("a");
  CHECK(message([&] {
          document.refuse_unused();
        }).starts_with("scene.toml:6:1: unknown key 'z' in [b.inner]; "));
}

TEST_CASE("an unknown table and an unknown key of an inline table are placed at the key") {
  const Document document = document_of("[tme]\nstep = 1\n[wall]\nmove = { amplitude = 1, frequncy = 2 }\n");
  const Table wall = document.root().table("wall");
  wall.table("move").number("amplitude");
  wall.table("move").number("frequency", 0.0);
  document.root().optional_table("time");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:1:2: unknown key 'tme' in the file; did you mean 'time'? known keys: wall, time");
  document.root().accept("tme");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:4:25: unknown key 'frequncy' in [wall.move]; did you mean 'frequency'? "
        "known keys: amplitude, frequency");
}

TEST_CASE("errors of the builder are placed") {
  const Table root = document_of("a = 1\n[t]\n  b = [1, 2]\n").root();
  const Table t = root.table("t");
  CHECK(std::string(t.error("b", "is odd", "make it even").what()) == "scene.toml:3:7: is odd; make it even");
  CHECK(std::string(t.error("b", 1, "is odd", "make it even").what()) ==
        "scene.toml:3:11: is odd; make it even");
  CHECK(std::string(t.error("b", 9, "is odd", "make it even").what()) ==
        "scene.toml:3:7: is odd; make it even");
  CHECK(std::string(t.error("absent", "is odd", "make it even").what()) ==
        "scene.toml:2:1: is odd; make it even");
  CHECK(std::string(t.error("is odd", "make it even").what()) == "scene.toml:2:1: is odd; make it even");
  CHECK(root.place("a") == "scene.toml:1:5");
  CHECK(root.place() == "scene.toml:1:1");
}

TEST_CASE("an error may be placed inside a string, where it is written as it is read") {
  const Document document =
      document_of("a = 'xyz'\nb = \"\u00b5\u00e9yz\"\nc = \"\\u0061yz\"\nd = \"\"\"\nxyz\"\"\"\n");
  const Table root = document.root();
  const auto place = [&](const char* key, std::size_t byte) {
    return std::string(root.error_in_string(key, byte, "what", "cure").what());
  };
  CHECK(place("a", 0) == "scene.toml:1:6: what; cure");
  CHECK(place("a", 3) == "scene.toml:1:9: what; cure");
  CHECK(place("b", 4) == "scene.toml:2:8: what; cure");  // two letters of two bytes
  CHECK(place("c", 1) == "scene.toml:3:5: at character 2: what; cure");
  CHECK(place("d", 2) == "scene.toml:4:5: at character 3: what; cure");
}
