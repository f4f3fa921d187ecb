#include "document_support.hpp"

#include <catch2/catch.hpp>

using namespace scree::document;
using scree::test::document_of;
using scree::test::message;
using Texts = std::vector<std::string>;

TEST_CASE("any value is given as TOML that an override takes") {
  const Document document = document_of(
      "a = 1e-5\nb = 'say \"x\"'\nc = { d = [1, 2.0], e = true }\nlist = [[1, 2], 'x', { f = 1 }]\n[g]\nh = "
      "1\n");
  const Table root = document.root();
  CHECK(root.toml("a") == "1e-5");
  CHECK(root.toml("b") == "\"say \\\"x\\\"\"");
  CHECK(root.toml("c") == "{ d = [1, 2.0], e = true }");
  CHECK(root.toml_elements("list") == Texts{"[1, 2]", "\"x\"", "{ f = 1 }"});
  CHECK(root.is_inline_table("c"));
  CHECK_FALSE(root.is_inline_table("g"));
  CHECK_FALSE(root.is_inline_table("a"));
  CHECK(root.place("list", 1) == "scene.toml:4:17");
  CHECK(
      message([&] { document.refuse_unused(); }).starts_with("scene.toml:5:2: unknown key 'g' in the file"));
  root.table("g");
  CHECK(message([&] { document.refuse_unused(); }).starts_with("scene.toml:6:1: unknown key 'h' in [g]"));
  CHECK(message([&] { root.toml_elements("a"); }) ==
        "scene.toml:1:5: a is a floating-point number (1e-5); give an array of values");
  CHECK(message([&] { root.toml("z"); }) == "scene.toml:1:1: the file has no 'z'; add z = <value>");
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
