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

TEST_CASE("lists of whole numbers are read with their range") {
  const Table root = document_of("good = [1, 2]\nbad = [1, -2]\nworse = [1.5]\n").root();
  CHECK(root.integers("good") == std::vector<std::int64_t>{1, 2});
  CHECK(message([&] {
          root.integers("bad", Range::non_negative());
        }).starts_with("scene.toml:2:11: bad[1] = -2 "));
  CHECK(
      message([&] { root.integers("worse"); }).starts_with("scene.toml:3:10: worse[0] is a floating-point "));
}
