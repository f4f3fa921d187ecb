#include "chart_axis.hpp"

#include "text_style.hpp"

#include <cmath>

#include <vtkAxis.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStringArray.h>

namespace scree::pictures {

ChartScale::ChartScale(double lower, double upper, bool logarithmic, double pad) : logarithmic_(logarithmic) {
  const Range range = padded(raw(lower), raw(upper), pad);
  lower_ = range.lower;
  upper_ = range.upper;
}

double ChartScale::raw(double value) const { return logarithmic_ ? std::log10(value) : value; }

double ChartScale::position(double value) const { return (raw(value) - lower_) / (upper_ - lower_); }

Ticks ChartScale::ticks(int target) const {
  if (!logarithmic_) return linear_ticks(lower_, upper_, target);
  return logarithmic_ticks(std::pow(10.0, lower_), std::pow(10.0, upper_), target);
}

void ChartScale::apply(vtkAxis* axis, const Ticks& ticks, double font) const {
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    positions->InsertNextValue(position(ticks.values[k]));
    labels->InsertNextValue(ticks.labels[k]);
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(0, 1);
  axis->SetCustomTickPositions(positions, labels);
  axis->SetTitle("");
  TextStyle{font}.apply_font(axis->GetLabelProperties());
  axis->SetTickLength(float(0.35 * font));
  axis->SetLabelOffset(float(0.6 * font));
  axis->GetPen()->SetWidth(float(font / 14));
  axis->GetPen()->SetColorF(0.1, 0.1, 0.1);
  axis->GetGridPen()->SetWidth(float(font / 20));
  axis->GetGridPen()->SetColorF(0.88, 0.88, 0.88);
}

}  // namespace scree::pictures
