#include "text_style.hpp"

#include <cmath>
#include <filesystem>

#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <scree/charts/text_fit.hpp>

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

double text_width(const std::string& line, const TextStyle& style) {
  vtkNew<vtkTextProperty> property;
  style.apply_font(property);
  int box[4] = {0, 0, 0, 0};
  const int dots_per_inch = 72;  // makes font sizes pixels
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(charts::shown_part(line)), box,
                                                 dots_per_inch);
  return box[1] - box[0] + 1;
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

void draw_text(vtkContext2D* painter, double x, double y, const std::string& text, const TextStyle& style,
               double room) {
  if (text.empty()) return;
  TextStyle smaller = style;
  const auto width = [&](const std::string& line, double size) {
    smaller.size = size;
    return text_width(line, smaller);
  };
  const charts::FittedText fitted = charts::fit_text(text, style.size, room, width);
  smaller.size = fitted.size;
  vtkNew<vtkTextProperty> property;
  smaller.apply_font(property);
  property->SetOrientation(style.upwards ? 90 : 0);
  property->SetVerticalJustificationToCentered();
  property->SetJustification(style.align == Align::left     ? VTK_TEXT_LEFT
                             : style.align == Align::center ? VTK_TEXT_CENTERED
                                                            : VTK_TEXT_RIGHT);
  painter->ApplyTextProp(property);
  painter->DrawString(float(x), float(y), fitted.line.c_str());
}

}  // namespace scree::pictures
