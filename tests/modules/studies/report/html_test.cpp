#include "html.hpp"

#include <catch2/catch.hpp>

using namespace scree::report;

TEST_CASE("text of users is escaped", "[report]") {
  CHECK(escaped("a<b> & \"c\"") == "a&lt;b&gt; &amp; &quot;c&quot;");
  CHECK(escaped("3λ/4\x01\n\xff") == "3λ/4  ?");
  CHECK(escaped_lines("a\n<b\n", 100) == "a\n&lt;b\n");
  CHECK(escaped_lines("abcdef", 3) == "abc\n...\n");
  CHECK(element("p", "x", "note") == "<p class=\"note\">x</p>");
  CHECK(breakable("a.b_c") == "a.<wbr>b_<wbr>c");
}

TEST_CASE("sections and folds without content are left out", "[report]") {
  CHECK(section("A", "").empty());
  CHECK(folded("A", "").empty());
  CHECK(Facts().html().empty());
  CHECK(Table({{"a"}}).html().empty());
}

TEST_CASE("a table leaves out columns without cells and counts rows beyond its length", "[report]") {
  Table table({{"name"}, {"value", true}, {"empty", true}});
  for (int k = 0; k < 403; ++k) table.add({"n", "1", "–"});
  const std::string html = table.html("table.csv");
  CHECK(html.find("empty") == html.npos);
  CHECK(html.find("<th scope=\"col\" class=\"number\">value</th>") != html.npos);
  CHECK(html.find("3 rows more in table.csv.") != html.npos);
}

TEST_CASE("base64 is that of RFC 4648", "[report]") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string("\xff\x00\xfe", 3)) == "/wD+");
}

TEST_CASE("addresses of paths have no signs with a meaning", "[report]") {
  CHECK(address("friction=0.1,seed=2") == "friction=0.1,seed=2");
  CHECK(address("a b\"<:#?%") == "a%20b%22%3C%3A%23%3F%25");
}
