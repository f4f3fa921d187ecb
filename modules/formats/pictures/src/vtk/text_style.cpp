#include "text_style.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

namespace scree::pictures {
namespace {

struct FontFiles {
  std::string regular;
  std::string bold;
};

FontFiles find_font() {
  const std::string folder = "/usr/share/fonts/truetype/";
  const FontFiles known[] = {
      {folder + "liberation2/LiberationSans-Regular.ttf", folder + "liberation2/LiberationSans-Bold.ttf"},
      {folder + "liberation/LiberationSans-Regular.ttf", folder + "liberation/LiberationSans-Bold.ttf"},
      {folder + "dejavu/DejaVuSans.ttf", folder + "dejavu/DejaVuSans-Bold.ttf"}};
  for (const FontFiles& files : known)
    if (std::filesystem::exists(files.regular) && std::filesystem::exists(files.bold)) return files;
  return {};
}

// The style, reduced to not less than two thirds of its size if the line is longer than `room`.
TextStyle fitted(const std::string& line, const TextStyle& style, double room) {
  const double width = text_width(line, style);
  TextStyle smaller = style;
  if (width > room) smaller.size *= std::max(2.0 / 3, room / width);
  return smaller;
}

// The first `bytes` of a line, without splitting a UTF-8 character, and an ellipsis.
std::string beginning(const std::string& line, std::size_t bytes) {
  while (bytes > 0 && (line[bytes] & 0xC0) == 0x80) --bytes;
  return line.substr(0, bytes) + "...";
}

// The line, shortened with an ellipsis if it is longer than `room`.
std::string cut(const std::string& line, const TextStyle& style, double room) {
  const auto fits = [&](const std::string& text) { return text_width(text, style) <= 1.02 * room; };
  if (fits(line)) return line;
  std::size_t fitting = 0, too_long = line.size();
  while (too_long - fitting > 1) {
    const std::size_t middle = (fitting + too_long) / 2;
    (fits(beginning(line, middle)) ? fitting : too_long) = middle;
  }
  return beginning(line, fitting);
}

}  // namespace

void TextStyle::apply_font(vtkTextProperty* property) const {
  static const FontFiles font = find_font();
  if (font.regular.empty()) {
    property->SetFontFamilyToArial();
    property->SetBold(bold);
  } else {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile((bold ? font.bold : font.regular).c_str());
    property->SetBold(false);
  }
  property->SetColor(0.1, 0.1, 0.1);
  property->SetFontSize(int(std::lround(size)));
}

std::string shown_part(const std::string& line) {
  constexpr std::size_t longest = 400;  // bytes; no picture is wide enough for them
  return line.size() > longest ? beginning(line, longest) : line;
}

double text_width(const std::string& line, const TextStyle& style) {
  vtkNew<vtkTextProperty> property;
  style.apply_font(property);
  int box[4] = {0, 0, 0, 0};
  const int dots_per_inch = 72;  // makes font sizes pixels
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(shown_part(line)), box,
                                                 dots_per_inch);
  return box[1] - box[0] + 1;
}

void draw_text(vtkContext2D* painter, double x, double y, const std::string& text, const TextStyle& style,
               double room) {
  if (text.empty()) return;
  const std::string line = shown_part(text);
  const TextStyle smaller = fitted(line, style, room);
  vtkNew<vtkTextProperty> property;
  smaller.apply_font(property);
  property->SetOrientation(style.upwards ? 90 : 0);
  property->SetVerticalJustificationToCentered();
  property->SetJustification(style.align == Align::left     ? VTK_TEXT_LEFT
                             : style.align == Align::center ? VTK_TEXT_CENTERED
                                                            : VTK_TEXT_RIGHT);
  painter->ApplyTextProp(property);
  painter->DrawString(float(x), float(y), cut(line, smaller, room).c_str());
}

}  // namespace scree::pictures
