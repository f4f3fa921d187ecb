#include "chart_labels.hpp"

#include "chart_curve.hpp"
#include "text_style.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>

namespace scree::pictures {
vtkStandardNewMacro(ChartLabels)

    bool ChartLabels::Paint(vtkContext2D* painter) {
  const double font = layout->font;
  const Box& plot = layout->plot;
  double y = layout->height - 1.3 * font;
  for (const std::string& line : layout->title_lines) {
    draw_text(painter, layout->width / 2, y, line, {1.25 * font, Align::center, true},
              layout->width - 2 * font);
    y -= 1.6 * font;
  }
  if (!layout->note.empty())
    draw_text(painter, layout->width / 2, y + 0.15 * font, layout->note, {0.9 * font, Align::center},
              layout->width - 2 * font);
  draw_text(painter, plot.left + plot.width / 2, 1.1 * font, spec->x_label, {1.1 * font, Align::center},
            layout->width - 2 * font);
  draw_text(painter, 1.2 * font, plot.bottom + plot.height / 2, spec->y_label,
            {1.1 * font, Align::center, false, true}, layout->height - 2 * font);
  if (layout->legend) paint_legend(painter, *layout->legend);
  return true;
}

void ChartLabels::paint_legend(vtkContext2D* painter, const Box& box) const {
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(0.6, 0.6, 0.6);
  painter->GetPen()->SetOpacityF(1);
  painter->GetPen()->SetWidth(float(layout->font / 20));
  painter->GetBrush()->SetColor(255, 255, 255, 255);
  painter->DrawRect(float(box.left), float(box.bottom), float(box.width), float(box.height));
  for (std::size_t row = 0; row < spec->series.size(); ++row) paint_legend_row(painter, box, row);
}

void ChartLabels::paint_legend_row(vtkContext2D* painter, const Box& box, std::size_t row) const {
  const double font = layout->font;
  const ChartSeries& series = spec->series[row];
  const CurveStyle style = CurveStyle::of(series, row, font);
  const double rows_above = double(row) + 0.5;
  const double y = box.bottom + box.height - (legend_pad / 2 + legend_line * rows_above) * font;
  const double left = box.left + legend_pad * font, right = left + legend_sample * font;
  std::vector<float> pieces = line_pieces({left, right}, {y, y}, style.line, font);
  painter->GetPen()->SetColorF(style.color[0], style.color[1], style.color[2]);
  painter->GetBrush()->SetColorF(style.color[0], style.color[1], style.color[2], 1);
  painter->GetPen()->SetWidth(float(style.line_width));
  if (!pieces.empty()) painter->DrawLines(pieces.data(), int(pieces.size() / 2));
  if (style.marker != vtkPlotPoints::NONE) {
    float middle[] = {float((left + right) / 2), float(y)};
    painter->GetPen()->SetWidth(float(style.marker_size));
    painter->DrawMarkers(style.marker, false, middle, 1);
  }
  draw_text(painter, right + legend_pad * font, y, series.name, {font},
            box.left + box.width - right - legend_pad * font);
}

}  // namespace scree::pictures
