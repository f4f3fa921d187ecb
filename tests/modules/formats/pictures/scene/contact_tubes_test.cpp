#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("contacts are drawn from end to end, sliding ones in red", "[snapshot]") {
  Frame frame = pair({0.2, 0.5, 0}, {0.8, 0.5, 0}, 2);
  frame.contact_from = {0.2, 0.5, 0};
  frame.contact_to = {0.8, 0.5, 0};
  frame.contact_normal_force = {5};
  frame.contact_tangential_force = {1};
  frame.contact_overlap = {1e-6};
  frame.contact_sliding = {1};
  const auto is_red = [](const Rgb& c) { return c[0] > 180 && c[1] < 80 && c[2] < 80; };
  RenderOptions options = by_speed("");
  const Picture without = draw(frame, options);
  CHECK(find_blob(without, is_red).pixels == 0);
  const Blob violet = find_blob(without, is_violet), yellow = find_blob(without, is_yellow);
  options.show_contacts = true;
  const Picture picture = draw(frame, options);
  const Blob bar = find_blob(picture, is_red);
  CHECK(find_blob(picture, is_violet).pixels == 0);  // discs are pale, so that bars stand out
  CHECK(bar.pixels > 1000);
  CHECK(bar.x == Approx((violet.x + yellow.x) / 2).margin(8));
}

TEST_CASE("of strong contacts only those above the mean force are drawn, and bodies can be left out",
          "[snapshot]") {
  // 1 N above, 5 N below: the mean is 3 N.
  Frame frame = pair({0.2, 0.5, 0}, {0.8, 0.5, 0}, 2);
  frame.contact_from = {0.2, 0.8, 0, 0.2, 0.3, 0};
  frame.contact_to = {0.8, 0.8, 0, 0.8, 0.3, 0};
  frame.contact_normal_force = {1, 5};
  frame.contact_tangential_force = {0, 0};
  frame.contact_overlap = {1e-6, 1e-6};
  frame.contact_sliding = {0, 0};
  const auto is_ink = [](const Rgb& c) { return c[0] < 120; };
  RenderOptions options = by_speed("");
  options.show_contacts = true;
  options.show_bodies = false;
  const Blob both = find_blob(draw(frame, options), is_ink);
  CHECK(both.pixels > 500);
  options.strong_contacts = true;
  const Picture picture = draw(frame, options);
  const Blob strong = find_blob(picture, is_ink);
  CHECK(strong.pixels > 500);
  CHECK(strong.y > both.y + 5);  // of the lower one alone; y counts from above
  CHECK(find_blob(picture, is_yellow).pixels == 0);
}
