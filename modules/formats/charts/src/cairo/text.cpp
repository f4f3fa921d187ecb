#include "text.hpp"

#include "embedded_fonts.hpp"

#include <cairo-ft.h>
#include <ft2build.h>
#include <numbers>
#include FT_FREETYPE_H

#include <scree/charts/text_fit.hpp>
#include <scree/error.hpp>

namespace scree::charts {
namespace {

// Of the fonts, over the size.
constexpr double half_capital = 0.365;

cairo_font_face_t* load(std::string_view font) {
  static FT_Library library = nullptr;
  FT_Face face = nullptr;
  if ((library == nullptr && FT_Init_FreeType(&library) != 0) ||
      FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(font.data()), FT_Long(font.size()), 0,
                         &face) != 0)
    throw Error("charts: FreeType cannot load the font; check the installation of libfreetype6",
                ExitStatus::failure);
  return cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
}

// Never destroyed, since cairo keeps references to them.
cairo_font_face_t* font_face(bool bold) {
  static cairo_font_face_t* const regular_face = load(regular_font());
  static cairo_font_face_t* const bold_face = load(bold_font());
  return bold ? bold_face : regular_face;
}

// Without hints text has the same shape and width at every size.
cairo_font_options_t* font_options() {
  static cairo_font_options_t* const options = [] {
    cairo_font_options_t* made = cairo_font_options_create();
    cairo_font_options_set_hint_style(made, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(made, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(made, CAIRO_ANTIALIAS_GRAY);
    return made;
  }();
  return options;
}

}  // namespace

double text_width(const std::string& line, double size, bool bold) {
  cairo_matrix_t scale, identity;
  cairo_matrix_init_scale(&scale, size, size);
  cairo_matrix_init_identity(&identity);
  cairo_scaled_font_t* font = cairo_scaled_font_create(font_face(bold), &scale, &identity, font_options());
  cairo_text_extents_t extents;
  cairo_scaled_font_text_extents(font, shown_part(line).c_str(), &extents);
  cairo_scaled_font_destroy(font);
  return extents.x_advance;
}

void draw_text(cairo_t* cairo, double x, double y, const std::string& text, const TextStyle& style,
               double room) {
  if (text.empty()) return;
  const bool bold = style.bold;
  const FittedText fitted = fit_text(text, style.size, room, [&](const std::string& line, double size) {
    return text_width(line, size, bold);
  });
  const double length = text_width(fitted.line, fitted.size, bold);
  const double share = style.align == Align::left ? 0 : style.align == Align::center ? 0.5 : 1;
  cairo_save(cairo);
  cairo_translate(cairo, x, y);
  if (style.upwards) cairo_rotate(cairo, -std::numbers::pi / 2);
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  cairo_set_font_face(cairo, font_face(bold));
  cairo_set_font_size(cairo, fitted.size);
  cairo_set_font_options(cairo, font_options());
  cairo_move_to(cairo, -share * length, half_capital * fitted.size);
  if (cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_IMAGE) {
    cairo_text_path(cairo, fitted.line.c_str());
    cairo_fill(cairo);
  } else {
    cairo_show_text(cairo, fitted.line.c_str());
  }
  cairo_restore(cairo);
}

}  // namespace scree::charts
