#include "document_support.hpp"

#include <catch2/catch.hpp>

#include <scree/scenario/names.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("a name is found by its index, and an unknown one is refused with the nearest", "[scenario]") {
  const document::Table root = document_of("wall = 'bx'\nlist = ['plane', 'bx']\n").root();
  const std::vector<std::string> names = {"plane", "box"};
  CHECK(find_name(root, "wall", "wall", "box", names) == 1);
  CHECK(message([&] { find_name(root, "wall", "wall", "bx", names); }) ==
        "scene.toml:1:8: no wall 'bx'; did you mean 'box'?");
  CHECK(message([&] { find_name(root, "list", "wall", "bx", names, 1); }) ==
        "scene.toml:2:18: no wall 'bx'; did you mean 'box'?");
}

TEST_CASE("names differ, and those that are not given are numbered past the given ones", "[scenario]") {
  const document::Document document =
      document_of("[[a]]\n[[a]]\n[[a]]\nname = 'law_3'\n[[a]]\n[[a]]\nname = 'law'\n[[a]]\nname = ''\n");
  const std::vector<document::Table> tables = document.root().tables("a");
  UniqueNames names("law");
  CHECK(names.add_or_number(tables[0], "law") == "law");
  CHECK(names.add_or_number(tables[1], "law") == "law_2");
  CHECK(names.add_or_number(tables[2], "law") == "law_3");
  CHECK(names.add_or_number(tables[3], "law") == "law_4");
  CHECK(message([&] { names.add_or_number(tables[4], "law"); }) ==
        "scene.toml:7:8: the law name 'law' is already in use; give each a different name");
  CHECK(message([&] {
          names.add_or_number(tables[5], "law");
        }).starts_with("scene.toml:9:8: the law name is empty; "));
}

TEST_CASE("a name of a file has letters, digits, '_' and '-' only, 100 at most", "[scenario]") {
  const document::Table root = document_of("name = 'x'\n").root();
  const auto refused = [&](const std::string& name) {
    return message([&] { check_file_name(root, name); }) != "no error";
  };
  for (const std::string good : {"a", "A-1_b", "\xC3\xA9"}) CHECK_FALSE(refused(good));
  for (const std::string bad : {"", ".", "a.b", "a/b", "a b", "a\n", "a\\"}) CHECK(refused(bad));
  CHECK_FALSE(refused(std::string(100, 'a')));
  CHECK(refused(std::string(101, 'a')));
}
