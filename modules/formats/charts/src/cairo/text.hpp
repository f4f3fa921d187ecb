#pragma once

#include <cairo.h>
#include <string>

namespace scree::charts {

enum class Align { left, center, right };

// Style of a line of text; its anchor is at half the height of its capitals.
struct TextStyle {
  double size;
  Align align = Align::left;
  bool bold = false;
  bool upwards = false;
};

// Width of one line.
double text_width(const std::string& line, double size, bool bold = false);

// Draws one line, in at most the length `room` as by fit_text(). Letters are outlines in pictures of pixels:
// cairo would place them on whole pixels.
void draw_text(cairo_t* cairo, double x, double y, const std::string& text, const TextStyle& style,
               double room);

}  // namespace scree::charts
