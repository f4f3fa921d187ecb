#include <catch2/catch.hpp>

#include <scree/charts/text_fit.hpp>

using namespace scree::charts;

namespace {

// Each byte is half as wide as high.
double width(const std::string& line, double size) { return 0.5 * size * double(line.size()); }

}  // namespace

TEST_CASE("a line is reduced to two thirds of its size, then cut", "[charts]") {
  const auto fitted = [](const std::string& line, double room) { return fit_text(line, 10, room, width); };
  CHECK(fitted("0123456789", 50).size == 10);
  CHECK(fitted("0123456789", 40).size == Approx(8));
  CHECK(fitted("0123456789", 40).line == "0123456789");
  CHECK(fitted("0123456789", 25).size == Approx(20.0 / 3));
  CHECK(fitted("0123456789", 25).line == "0123...");  // seven bytes of 10/3 in 25, to 2 %
}

TEST_CASE("a cut leaves characters whole", "[charts]") {
  CHECK(fit_text("µµµµµµµµ", 10, 20, width).line == "µ...");
  CHECK(shown_part(std::string(1000, 'a')).size() == 403);
}

TEST_CASE("bytes that are no text are replaced", "[charts]") {
  CHECK(drawable_text("µ = 0.3 ≤ 𝛼") == "µ = 0.3 ≤ 𝛼");
  CHECK(drawable_text("a\tb\nc\x7F") == "a b c ");
  // Alone, too long, a surrogate, beyond the last character, cut off.
  CHECK(drawable_text("\x80|\xC0\xAF|\xED\xA0\x80|\xF5|\xE2\x89") == "?|??|???|?|??");
}
