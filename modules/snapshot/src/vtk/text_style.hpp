#pragma once

#include <string>

class vtkContext2D;
class vtkTextProperty;

namespace scree::snapshot {

enum class Align { left, center, right };

// Of text whose anchor is half-way up its height.
struct TextStyle {
  double size;  // (drawn pixels)
  Align align = Align::left;
  bool bold = false;
  bool upwards = false;

  // Colour, size and font: a common sans-serif one of the system or, where there is none, VTK's own.
  void apply_font(vtkTextProperty* property) const;
};

// Length of one line (drawn pixels).
double text_width(const std::string& line, const TextStyle& style);

// Writes one line at its anchor; smaller, down to two thirds, and then cut, where it would be longer than
// room. All in drawn pixels.
void draw_text(vtkContext2D* painter, double x, double y, const std::string& line, const TextStyle& style,
               double room);

}  // namespace scree::snapshot
