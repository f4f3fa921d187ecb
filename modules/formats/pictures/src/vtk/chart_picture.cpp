#include "chart_picture.hpp"

#include "chart_curve.hpp"
#include "chart_gaps.hpp"
#include "chart_labels.hpp"
#include "chart_layout.hpp"

#include <cmath>

#include <fmt/format.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkTable.h>

#include <scree/error.hpp>

namespace scree::pictures {
namespace {

void check(const ChartSpec& spec) {
  check_size(spec.width, spec.height);
  if (spec.series.empty())
    throw Error(fmt::format("chart: \"{}\" has no series; give one or more", spec.title));
  for (const ChartSeries& series : spec.series) {
    if (series.x.empty() || series.x.size() != series.y.size())
      throw Error(
          fmt::format("chart: series \"{}\" has {} x and {} y values; give equal numbers, at least one",
                      series.name, series.x.size(), series.y.size()));
  }
}

vtkNew<vtkTable> empty_table() {
  vtkNew<vtkTable> table;
  for (const char* name : {"x", "y"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  return table;
}

void append(vtkTable* table, double x, double y) {
  vtkDoubleArray::SafeDownCast(table->GetColumn(0))->InsertNextValue(x);
  vtkDoubleArray::SafeDownCast(table->GetColumn(1))->InsertNextValue(y);
}

// Adds a plot; the points, in 0..1, are markers or pairs of line ends.
void add_plot(vtkChartXY* chart, vtkTable* table, const CurveStyle& style, int marker) {
  const bool line = marker == vtkPlotPoints::NONE;
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(line ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  plot->GetPen()->SetColorF(style.color[0], style.color[1], style.color[2]);
  plot->GetBrush()->SetColorF(style.color[0], style.color[1], style.color[2]);
  plot->SetWidth(float(style.line_width));
  plot->SetMarkerStyle(marker);
  plot->SetMarkerSize(float(style.marker_size));
  if (auto* plot_line = vtkPlotLine::SafeDownCast(plot)) plot_line->SetPolyLine(false);
}

void add_series(vtkChartXY* chart, const ChartSeries& series, const CurveStyle& style,
                const ChartLayout& layout) {
  std::vector<double> x, y;  // (drawn pixels) within the plot
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    x.push_back(layout.x.position(series.x[k]) * layout.plot.width);
    y.push_back(layout.y.position(series.y[k]) * layout.plot.height);
  }
  const std::vector<float> pieces = line_pieces(x, y, style.line, layout.font);
  vtkNew<vtkTable> ends = empty_table(), points = empty_table();
  for (std::size_t k = 0; k < pieces.size(); k += 2)
    append(ends, pieces[k] / layout.plot.width, pieces[k + 1] / layout.plot.height);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!std::isnan(x[k])) append(points, x[k] / layout.plot.width, y[k] / layout.plot.height);
  if (!pieces.empty()) add_plot(chart, ends, style, vtkPlotPoints::NONE);
  if (style.marker != vtkPlotPoints::NONE) add_plot(chart, points, style, style.marker);
}

void set_axes(vtkChartXY* chart, const ChartLayout& layout) {
  chart->SetAutoAxes(false);
  layout.x.apply(chart->GetAxis(vtkAxis::BOTTOM), layout.x_ticks, layout.font);
  layout.y.apply(chart->GetAxis(vtkAxis::LEFT), layout.y_ticks, layout.font);
  for (int side : {vtkAxis::TOP, vtkAxis::RIGHT}) {  // complete the frame
    vtkAxis* axis = chart->GetAxis(side);
    layout.x.apply(axis, {}, layout.font);
    axis->SetVisible(true);
    axis->SetLabelsVisible(false);
    axis->SetTicksVisible(false);
    axis->SetGridVisible(false);
  }
}

}  // namespace

Picture chart_picture(OffscreenContext& context, const ChartSpec& given) {
  check(given);
  std::string note;
  const ChartSpec spec = drawable_chart(given, note);
  const ChartLayout layout = ChartLayout::of(spec, note);
  vtkNew<vtkChartXY> chart;
  set_axes(chart, layout);
  for (std::size_t k = 0; k < spec.series.size(); ++k)
    add_series(chart, spec.series[k], CurveStyle::of(spec.series[k], k, layout.font), layout);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetSize(vtkRectf(float(layout.plot.left), float(layout.plot.bottom), float(layout.plot.width),
                          float(layout.plot.height)));
  vtkNew<ChartLabels> labels;
  labels->spec = &spec;
  labels->layout = &layout;

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->SetRenderer(renderer);
  actor->GetScene()->AddItem(chart);
  actor->GetScene()->AddItem(labels);
  renderer->AddActor(actor);
  return context.draw(spec.width, spec.height, {renderer});
}

}  // namespace scree::pictures
