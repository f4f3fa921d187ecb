#include <catch2/catch.hpp>

#include <scree/files/text.hpp>

using namespace scree::files;

TEST_CASE("control characters are escaped as the reader of the text needs it") {
  const std::string text = "a\n\r\t\x1B\x7F\"\\ \xC3\xA9";
  CHECK(escaped(text) == "a\\n\\r\\t\\x1B\\x7F\"\\ \xC3\xA9");
  CHECK(escaped(text, Escapes::lines) == "a\n\\r\\t\\x1B\\x7F\"\\ \xC3\xA9");
  CHECK(escaped(text, Escapes::bytes) == "a\\x0a\\x0d\\x09\\x1b\\x7f\"\\ \\xc3\\xa9");
  CHECK(escaped(text, Escapes::toml) == "a\\n\\u000D\\u0009\\u001B\\u007F\\\"\\\\ \xC3\xA9");
}

TEST_CASE("a long text is cut between letters") {
  CHECK(one_line("abc", 3) == "abc");
  CHECK(one_line("abcd", 3) == "abc...");
  CHECK(one_line("ab\xC3\xA9", 3) == "ab...");
  CHECK(one_line("\n\n\n", 2) == "\\n\\n...");
}
