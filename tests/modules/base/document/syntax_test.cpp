#include "document_support.hpp"
#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

std::string syntax_message(std::string_view text) {
  return message([&] { document_of(text); });
}

}  // namespace

TEST_CASE("a syntax error is one line with place and cure") {
  struct Case {
    std::string text, start, cure;
  };
  const Case cases[] = {
      {"a = 1\na = 2\n", "scene.toml:2:", "; keep one of the two"},
      {"[a]\n[a]\n",
       "scene.toml:2:1: ", "; merge the two tables, or write [[name]] for each entry of a list"},
      {"\na = \n", "scene.toml:2:5: ", "; give the value behind the = on the same line"},
      {"a = 'x\n", "scene.toml:1:7: ", "; close the quote on the same line, or use \"\"\" for several lines"},
      {"a = tru\n", "scene.toml:1:8: ", "; write true or false, or put the word in quotes"},
      {"a 1\n", "scene.toml:1:3: ", "; write key = value"},
      {"a = [1,2\n", "scene.toml:", "; close the bracket, brace or quote that is open there"},
      {"a = 01\n", "scene.toml:1:", "; write the number without leading zeros"},
      {"a = .5\n", "scene.toml:1:5: ", "; put a digit on both sides of the decimal point, such as 0.5"},
      {"a = 1.\n", "scene.toml:1:7: ", "; put a digit behind the decimal point or exponent, such as 1.0"},
      {"a = 2e400\n", "scene.toml:1:", "; give a number of magnitude below 1.8e308"},
      {"a = 99999999999999999999\n", "scene.toml:1:", "; give a number that fits 64 bits"},
      {"a = 2 mm\n", "scene.toml:1:7: ", "; put each key = value on a line of its own"},
      {"a = 2mm\n",
       "scene.toml:1:6: ", "; write a plain number such as 2.5e-3, without a unit (all units are SI)"},
      {"a = 1,5\n", "scene.toml:1:6: ", "; use a decimal point, one value for each key, and [ ] for several"},
      {"a = glass\n",
       "scene.toml:1:5: ", "; give a number, true, false, an [array] or a \"string\" in quotes"},
      {"a = \"\xFF\"\n", "scene.toml:1:5: ", "; save the file as UTF-8 text"},
      {"a = \"\\q\"\n", "scene.toml:1:7: ", "; write \\\\ for a backslash, or use 'single quotes'"},
      {"a = {b = 1,\nc = 2}\n", "scene.toml:1:", "; write an inline table on one line, { a = 1, b = 2 }"},
      {"[a\n", "scene.toml:1:3: ", "; write [name] or [[name]] on a line of its own"},
  };
  for (const Case& wrong : cases) {
    INFO(wrong.text);
    const std::string line = syntax_message(wrong.text);
    INFO(line);
    CHECK(line.starts_with(wrong.start));
    CHECK(line.find(": not valid TOML: ") != std::string::npos);
    CHECK(line.ends_with(wrong.cure));
  }
}

TEST_CASE("a key that is given twice is named as it is written") {
  CHECK(syntax_message("[set]\n\"contact.friction\" = [1]\n\"contact.friction\" = [2]\n") ==
        "scene.toml:3:22: not valid TOML: the key \"contact.friction\" is given twice; keep one of the two");
  CHECK(syntax_message("a = { x = 1, b.x = 1, b.x = 2 }\n") ==
        "scene.toml:1:29: not valid TOML: the key b.x is given twice; keep one of the two");
}

TEST_CASE("nesting without end is refused, not followed") {
  const auto nested = [](int parts) {
    std::string header = "x = 1\n[a";
    for (int i = 0; i < parts; ++i) header += ".a";
    return header + "]\n";
  };
  CHECK(syntax_message(nested(60)) == "no error");
  CHECK(syntax_message(nested(100)) == "scene.toml:2:1: tables or arrays more than 64 deep; flatten them");
  CHECK(syntax_message(nested(300000)) == "scene.toml:2:1: tables or arrays more than 64 deep; flatten them");
  CHECK(syntax_message("a = " + std::string(100000, '[')).ends_with("; flatten the arrays"));
  std::string quoted = "x = 1\n' '", dotted = "a";
  for (int i = 0; i < 50000; ++i) quoted += " . ' '";
  for (int i = 0; i < 900; ++i) dotted += ".a";
  CHECK(syntax_message(quoted + " = 1\n") ==
        "scene.toml:2:1: tables or arrays more than 64 deep; flatten them");
  std::string in_line = dotted;
  for (int i = 0; i < 200; ++i) in_line += " = {" + dotted;
  CHECK(syntax_message(in_line) == "scene.toml:1:1: tables or arrays more than 64 deep; flatten them");
  const std::string dots(5000, '.');
  CHECK(syntax_message("a = '" + dots + "' # " + dots + "\nb = \"\"\"\\\"" + dots + "\n\"\"\"\n") ==
        "no error");
  std::string short_keys = "rows = [";
  for (int i = 0; i < 5000; ++i) short_keys += "{ a.b = 0.5 }, ";
  CHECK(syntax_message(short_keys + "]") == "no error");
  std::string table_of_numbers = "# 0.5";
  for (int i = 0; i < 5000; ++i) table_of_numbers += " 0.5";
  CHECK(syntax_message(table_of_numbers) == "no error");
  std::string numbers = "v = [0.5";
  for (int i = 0; i < 5000; ++i) numbers += " ,\t0.5";
  CHECK(document_of(numbers + "] # " + std::string(5000, '.') + "\n").root().numbers("v").size() == 5001);
}

TEST_CASE("long and odd text stays one readable line") {
  const Table root =
      document_of("a = '''l1\nl2'''\nb = '" + std::string(5000, 'x') + "'\n\"odd\\nkey\" = 1\n").root();
  CHECK(message([&] { root.number("a"); }) == "scene.toml:1:5: a is a string (\"l1\\nl2\"); give a number");
  CHECK(message([&] { root.number("b"); }).size() < 200);
  CHECK(message([&] {
          root.refuse_unused();
        }).starts_with("scene.toml:4:1: unknown key 'odd\\nkey' in the file; "));
}
