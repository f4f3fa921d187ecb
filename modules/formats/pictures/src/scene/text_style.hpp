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

// Draws one line at its anchor, in at most the length `room`, as by charts::fit_text(). All lengths in drawn
// pixels.
void draw_text(vtkContext2D* painter, double x, double y, const std::string& text, const TextStyle& style,
               double room);

}  // namespace scree::pictures
