#include "drawn_chart.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace scree::charts;

namespace {

// The smallest rectangle around what is dark in a part of a picture (pixels).
struct Ink {
  int left = 9999, top = 9999, right = -1, bottom = -1;

  Ink(const Pixels& picture, const Ink& part) {
    for (int y = part.top; y < part.bottom; ++y)
      for (int x = part.left; x < part.right; ++x) {
        if (picture.at(x, y)[0] >= 128) continue;
        left = std::min(left, x), right = std::max(right, x + 1);
        top = std::min(top, y), bottom = std::max(bottom, y + 1);
      }
  }
  Ink(int l, int t, int r, int b) : left(l), top(t), right(r), bottom(b) {}
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

const Ink title_part(0, 0, 1200, 50), x_part(0, 860, 1200, 900), y_part(0, 0, 45, 900);

Pixels labelled(const std::string& title, const std::string& x_label, const std::string& y_label) {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  spec.title = title, spec.x_label = x_label, spec.y_label = y_label;
  return drawn(spec);
}

}  // namespace

// H is symmetric, so that its ink is in the middle of its width; edges are known to a pixel.
TEST_CASE("text is in the middle of its place, and that of y is turned upwards", "[charts]") {
  const Pixels picture = labelled("HHHH", "HHHH", "HHHH");
  const Plot plot = Plot::of(picture);
  const Ink title(picture, title_part), x(picture, x_part), y(picture, y_part);
  CHECK(title.left + title.right == Approx(1200).margin(2));
  CHECK(x.left + x.right == Approx(plot.left + plot.right).margin(3));
  CHECK(y.top + y.bottom == Approx(plot.top + plot.bottom).margin(3));
  CHECK(y.height() == Approx(x.width()).margin(2));
  CHECK(y.width() == Approx(x.height()).margin(2));
  // Capitals of DejaVu are 0.73 of the font, of 1.1 and 1.25 labels of 22 pixels.
  CHECK(x.height() == Approx(0.73 * 1.1 * 22).margin(1));
  CHECK(title.height() == Approx(0.73 * 1.25 * 22).margin(1));
}

TEST_CASE("text that is too long for its place is made smaller, and then cut off", "[charts]") {
  const auto ink_of = [](std::size_t letters) {
    return Ink(labelled("", std::string(letters, 'H'), ""), x_part);
  };
  const Ink some = ink_of(20), more = ink_of(70), most = ink_of(5000);
  CHECK(more.height() < some.height());
  CHECK(most.height() > 5);
  for (const Ink& ink : {more, most}) {
    // At most 2 % longer than what leaves the size of a label at each end, 22 pixels.
    CHECK(ink.width() <= 1.02 * (1200 - 2 * 22));
    CHECK(ink.left + ink.right ==
          Approx(1200).margin(8));  // the dots at the end are narrower than their place
  }
}
