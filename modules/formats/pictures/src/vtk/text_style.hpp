#pragma once

#include <string>

class vtkContext2D;
class vtkTextProperty;

namespace scree::pictures {

enum class Align { left, center, right };

// Style of a line of text; the anchor is at half its height.
struct TextStyle {
  double size;  // (drawn pixels)
  Align align = Align::left;
  bool bold = false;
  bool upwards = false;

  // Sets colour, size and font: a common sans-serif font of the system, or VTK's own if there is none.
  void apply_font(vtkTextProperty* property) const;
};

// The line, or as much of the beginning of a very long one as a picture may show. Measuring a text takes time
// proportional to its length.
std::string shown_part(const std::string& line);

// Width of the shown part of one line (drawn pixels).
double text_width(const std::string& line, const TextStyle& style);

// Draws one line at its anchor; a line longer than `room` is reduced to not less than two thirds of its size,
// then cut. All lengths in drawn pixels.
void draw_text(vtkContext2D* painter, double x, double y, const std::string& text, const TextStyle& style,
               double room);

}  // namespace scree::pictures
