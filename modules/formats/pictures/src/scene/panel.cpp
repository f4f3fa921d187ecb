#include "panel.hpp"

#include "offscreen_context.hpp"
#include "text_style.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/charts/ticks.hpp>

namespace scree::pictures {
namespace {

void set_pen(vtkContext2D* painter, double width) {
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(0.1, 0.1, 0.1);
  painter->GetPen()->SetWidth(float(width));
}

void draw_line(vtkContext2D* painter, double x0, double y0, double x1, double y1) {
  painter->DrawLine(float(x0), float(y0), float(x1), float(y1));
}

}  // namespace

SceneLayout SceneLayout::of_size(int width, int height, bool scale_bar) {
  const int scale = supersampling(width, height);
  const double font = std::max(16.0, 21 * std::min(width / 1200.0, height / 900.0));
  return {width * scale, height * scale, scale, font * scale, scale_bar ? 2.2 * font * scale : 0};
}

vtkStandardNewMacro(Panel)

    bool Panel::Paint(vtkContext2D* painter) {
  if (shade) painter->DrawImage(0, float(std::lround(layout.note())), shade);
  paint_caption(painter);
  const std::vector<ColorField::Entry> legend = field ? field->legend() : std::vector<ColorField::Entry>();
  if (field) legend.empty() ? paint_color_bar(painter) : paint_legend(painter, legend);
  if (scale_bar > 0) paint_scale_bar(painter);
  paint_triad(painter);
  return true;
}

void Panel::paint_caption(vtkContext2D* painter) const {
  const double y = layout.height - layout.caption() / 2;
  const double time_room = 0.3 * layout.width;
  draw_text(painter, layout.font, y, title, {1.2 * layout.font, Align::left, true},
            layout.width - time_room - 3 * layout.font);
  draw_text(painter, layout.width - layout.font, y, time, {layout.font, Align::right}, time_room);
  draw_text(painter, layout.font, 0.6 * (layout.note() - layout.scale_strip), note, {0.9 * layout.font},
            layout.scene_width() - layout.font);
}

void Panel::paint_color_bar(vtkContext2D* painter) const {
  const double font = layout.font;
  const double left = layout.scene_width() + 1.2 * font, width = 1.3 * font;
  const double bottom = 0.30 * layout.height, top = layout.height - layout.caption() - 2.4 * font;
  const int bands = 256;
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  for (int band = 0; band < bands; ++band) {
    const auto color = field->color_at((band + 0.5) / bands);
    painter->GetBrush()->SetColor(color[0], color[1], color[2], 255);
    painter->DrawRect(float(left), float(bottom + (top - bottom) * band / bands), float(width),
                      float((top - bottom) / bands + 1));
  }
  set_pen(painter, 1.2 * layout.pixel_scale);
  draw_text(painter, layout.scene_width() + 0.4 * font, top + 1.3 * font, field->title, {font},
            layout.side() - 0.8 * font);
  const charts::Ticks ticks = charts::linear_ticks(field->lower, field->upper, 8, field->whole_numbers);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double y =
        bottom + (top - bottom) * (ticks.values[k] - field->lower) / (field->upper - field->lower);
    draw_line(painter, left + width, y, left + width + 0.3 * font, y);
    draw_text(painter, left + width + 0.6 * font, y, ticks.labels[k], {font}, layout.side() - 3.2 * font);
  }
}

void Panel::paint_legend(vtkContext2D* painter, const std::vector<ColorField::Entry>& legend) const {
  const double font = layout.font, left = layout.scene_width() + 1.2 * font;
  double y = layout.height - layout.caption() - 1.1 * font;
  draw_text(painter, layout.scene_width() + 0.4 * font, y, field->title, {font}, layout.side() - 0.8 * font);
  const double lowest = 9 * font;  // above the triad
  for (const auto& [color, label] : legend) {
    y -= 1.9 * font;
    if (y < lowest) break;
    set_pen(painter, 1.2 * layout.pixel_scale);
    painter->GetBrush()->SetColor(color[0], color[1], color[2], 255);
    painter->DrawRect(float(left), float(y - 0.5 * font), float(font), float(font));
    draw_text(painter, left + 1.5 * font, y, label, {font}, layout.side() - 3 * font);
  }
}

void Panel::paint_scale_bar(vtkContext2D* painter) const {
  const double font = layout.font, length = scale_bar * pixels_per_metre;
  const double left = font, y = layout.note() - layout.scale_strip + 0.4 * font;
  set_pen(painter, 2.5 * layout.pixel_scale);
  draw_line(painter, left, y, left + length, y);
  for (const double x : {left, left + length}) draw_line(painter, x, y - 0.3 * font, x, y + 0.3 * font);
  const charts::ScaledUnit unit = charts::scaled_unit(scale_bar, "m");
  draw_text(painter, left + length / 2, y + 0.9 * font,
            fmt::format("{:g} {}", scale_bar * unit.factor, unit.symbol), {font, Align::center}, 8 * font);
}

void Panel::paint_triad(vtkContext2D* painter) const {
  const double font = layout.font, length = 2.2 * font;
  const double x = layout.scene_width() + layout.side() / 2 - 0.6 * font, y = 3.8 * font;
  const char* names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const double dx = axes.right[k], dy = axes.up[k], shown = std::hypot(dx, dy);
    if (shown < 0.05) continue;  // points towards the viewer
    const double tip_x = x + length * dx, tip_y = y + length * dy;
    const double ux = dx / shown, uy = dy / shown, head = 0.45 * font;
    set_pen(painter, 1.6 * layout.pixel_scale);
    draw_line(painter, x, y, tip_x, tip_y);
    const double triangle[] = {tip_x + head * ux,       tip_y + head * uy,       tip_x - 0.5 * head * uy,
                               tip_y + 0.5 * head * ux, tip_x + 0.5 * head * uy, tip_y - 0.5 * head * ux};
    float corners[6];
    std::copy(std::begin(triangle), std::end(triangle), corners);
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColor(25, 25, 25, 255);
    painter->DrawPolygon(corners, 3);
    draw_text(painter, tip_x + 1.2 * font * ux, tip_y + 1.1 * font * uy, names[k], {font, Align::center},
              2 * font);
  }
}

}  // namespace scree::pictures
