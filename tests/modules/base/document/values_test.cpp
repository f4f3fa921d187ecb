#include "document_support.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;

TEST_CASE("values of every kind are read as written") {
  const Document document = document_of(
      "title = 'heap'\nseed = 9007199254740993\nratio = 0.1\nwhole = 3\nlid = true\n"
      "gravity = [0, -9.81]\ncorners = [[0, 0], [1, 0.5]]\nparts = ['a', 'b']\n");
  const Table root = document.root();
  CHECK(root.string("title") == "heap");
  CHECK(root.integer("seed") == 9007199254740993);
  CHECK(root.number("ratio") == 0.1);
  CHECK(root.number("whole") == 3.0);
  CHECK(root.boolean("lid"));
  CHECK(root.numbers("gravity") == std::vector<double>{0, -9.81});
  CHECK(root.numbers("gravity", 2) == std::vector<double>{0, -9.81});
  CHECK(root.rows("corners", 2) == std::vector<std::vector<double>>{{0, 0}, {1, 0.5}});
  CHECK(root.strings("parts") == std::vector<std::string>{"a", "b"});
  CHECK(root.choice("title", {"heap", "box"}) == "heap");
  CHECK(root.keys().front() == "title");
  CHECK_NOTHROW(document.refuse_unused());
}

TEST_CASE("an absent key gives the fallback, a present one does not") {
  const Table root = document_of("a = 1\nb = 'x'\nc = false\nd = [1]\n").root();
  CHECK(root.number("a", 7.0) == 1);
  CHECK(root.number("absent", 7.0, Range::positive("m")) == 7);
  CHECK(root.optional_number("a") == 1.0);
  CHECK_FALSE(root.optional_number("absent"));
  CHECK(root.integer("absent", 4) == 4);
  CHECK(root.integer("a", 4) == 1);
  CHECK(root.string("absent", "y") == "y");
  CHECK(root.string("b", "y") == "x");
  CHECK_FALSE(root.optional_string("absent"));
  CHECK_FALSE(root.boolean("c", true));
  CHECK(root.boolean("absent", true));
  CHECK(root.choice("absent", {"x", "y"}, "y") == "y");
}

TEST_CASE("the kind of a value can be asked for") {
  const Table root = document_of("i = 1\nf = 1.5\nt = {a = 1}\nr = [1]\ns = 's'\nb = true\n[[e]]\n").root();
  CHECK(root.is_number("i"));
  CHECK(root.is_number("f"));
  CHECK_FALSE(root.is_number("t"));
  CHECK(root.is_table("t"));
  CHECK_FALSE(root.is_table("r"));
  CHECK(root.is_array("r"));
  CHECK(root.is_array("e"));
  CHECK(root.is_string("s"));
  CHECK_FALSE(root.is_string("b"));
  CHECK(root.has("i"));
  CHECK_FALSE(root.has("absent"));
  CHECK_FALSE(root.is_number("absent"));
}

TEST_CASE("tables are found in each spelling") {
  const Table root =
      document_of("[[contact]]\nf = 1\n[[contact]]\nf = 2\n[single]\nf = 3\n[deep]\nin = {f = 4}\n").root();
  const std::vector<Table> contacts = root.tables("contact");
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[1].number("f") == 2);
  CHECK(contacts[1].path() == "contact[1]");
  CHECK(contacts[1].label() == "[[contact]]");
  REQUIRE(root.tables("single").size() == 1);
  CHECK(root.tables("single")[0].number("f") == 3);
  CHECK(root.tables("absent").empty());
  CHECK(document_of("[[wall]]\nx = 1\n").root().tables("wall")[0].path() == "wall");
  CHECK(root.table("deep").table("in").label() == "[deep.in]");
  CHECK(root.table("deep").table("in").place("f") == "scene.toml:8:11");
  CHECK_FALSE(root.optional_table("absent"));
  CHECK(root.optional_table("single")->number("f") == 3);
  CHECK(root.table_or_empty("snapshot").number("every", 0.5) == 0.5);
  CHECK(message([&] { root.table_or_empty("snapshot").number("every"); }) ==
        "scene.toml:1:1: [snapshot] has no 'every'; add every = <number>");
  CHECK(message([&] { root.table("contact"); }) ==
        "scene.toml:1:1: contact is an array of tables; keep one entry, written [contact]");
}

TEST_CASE("the resolved text reads back to the same values and to itself") {
  const Document document = document_of(
      "z = 1\nf = 2.0\ntiny = 5e-324\nthird = 0.3333333333333333\nbig = 1e22\nday = 1979-05-27T07:32:00Z\n"
      "[t]\ns = \"q\\\" b\\\\ n\\n t\\t \xC3\xA9 \\u0001\"\n\"odd key\" = {a = [1, [2.5, 'x']], b = "
      "{}}\nempty = []\n"
      "[t.u.v]\nw = -0.0\n[[e]]\nn = 1\n[e.sub]\nk = true\n[[e]]\n[lonely]\n");
  const std::string text = document.resolved_text();
  const Document again = Document::parse(text, "again.toml");
  CHECK(again.resolved_text() == text);
  const Table root = again.root();
  CHECK(root.is_number("f"));
  CHECK(root.number("tiny") == std::numeric_limits<double>::denorm_min());
  CHECK(root.number("third") == 0.3333333333333333);
  CHECK(root.number("big") == 1e22);
  CHECK(root.table("t").string("s") == "q\" b\\ n\n t\t \xC3\xA9 \x01");
  CHECK(root.table("t").table("odd key").table("b").keys().empty());
  CHECK(std::signbit(root.table("t").table("u").table("v").number("w")));
  CHECK(root.tables("e").size() == 2);
  CHECK(root.tables("e")[0].table("sub").boolean("k"));
  CHECK(root.has("lonely"));
  CHECK(text.find("\"odd key\" = { a = [1, [2.5, \"x\"]], b = {} }\n") != std::string::npos);
  CHECK(message([&] { root.integer("f"); }).find("(2.0)") != std::string::npos);
  CHECK(text.starts_with("z = 1\nf = 2.0\ntiny = 5e-324\nthird = 0.3333333333333333\nbig = 1e+22\nday = "));
}
