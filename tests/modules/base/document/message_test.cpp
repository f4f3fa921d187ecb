#include <cstdlib>
#include <random>

#include <catch2/catch.hpp>

#include <scree/document/message.hpp>

using namespace scree::document;

TEST_CASE("a word that is none of the candidates is answered by the nearest or by all") {
  CHECK(name_cure("bx", {"plane", "box"}) == "did you mean 'box'?");
  CHECK(name_cure("cylinder", {"plane", "box"}) == "there are: plane, box");
  CHECK(name_cure("box", {}) == "there are none");
  CHECK(suggestion("bx", {"plane", "box"}) == "did you mean 'box'? ");
  CHECK(suggestion("cylinder", {"plane", "box"}).empty());
  CHECK(name_cure("a\nc", {"a\nb"}) == "did you mean 'a\\nb'?");
}

TEST_CASE("numbers are written in the shortest form with the same bits") {
  CHECK(number_text(2e-5) == "2e-5");
  CHECK(number_text(1e-100) == "1e-100");
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(3) == "3");
  CHECK(toml_number_text(3) == "3.0");
  CHECK(toml_number_text(1e22) == "1e+22");
  CHECK(toml_number_text(-INFINITY) == "-inf");
  CHECK(toml_number_text(-NAN) == "nan");
  std::mt19937_64 random(1);
  for (int k = 0; k < 1000; ++k) {
    const double x = std::ldexp(double(random()), int(random() % 600) - 300);
    CHECK(std::strtod(number_text(x).c_str(), nullptr) == x);
  }
}

TEST_CASE("keys and words are listed as in a sentence") {
  CHECK(with_article("radius") == "a radius");
  CHECK(with_article("amplitude") == "an amplitude");
  CHECK(with_article("cycles") == "cycles");
  CHECK(with_article("normal_stiffness") == "a normal stiffness");
  CHECK(listed({"a", "b", "c"}) == "a, b, c");
  CHECK(any_of({"a"}) == "\"a\"");
  CHECK(any_of({"a", "b", "c"}) == "\"a\", \"b\" or \"c\"");
}
