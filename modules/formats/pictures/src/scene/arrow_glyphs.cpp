#include "arrow_glyphs.hpp"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <scree/error.hpp>

namespace scree::pictures {
namespace {

constexpr double shortest = 0.02;  // of the longest, which is seen

vtkNew<vtkPolyData> arrow_points(const Frame& frame, const ArrowField& arrows, const ColorField& lengths,
                                 double scale) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    if (lengths.values[i] < shortest) continue;
    points->InsertNextPoint(frame.position.data() + 3 * i);
    const double* v = arrows.vectors.data() + 3 * i;
    vectors->InsertNextTuple3(scale * v[0], scale * v[1], scale * v[2]);
    colors->InsertNextTypedTuple(lengths.color(i).data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->SetVectors(vectors);
  data->GetPointData()->SetScalars(colors);
  return data;
}

}  // namespace

ColorField arrow_lengths(const Frame& frame, const ArrowField& arrows) {
  if (arrows.vectors.size() != 3 * frame.particle_count())
    throw Error("arrows: their number differs from the number of particles; give one for each");
  ColorField field = {.title = arrows.title, .values = {}, .lower = 0, .upper = 1, .whole_numbers = false};
  double largest = 0;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    const double* v = arrows.vectors.data() + 3 * i;
    field.values.push_back(std::hypot(v[0], v[1], v[2]));
    if (!std::isfinite(field.values.back())) throw Error("arrows: one is not finite; give finite numbers");
    largest = std::max(largest, field.values.back());
  }
  if (largest > 0)
    for (double& value : field.values) value /= largest;
  return field;
}

void add_arrows(vtkRenderer* renderer, const Frame& frame, const ArrowField& arrows,
                const ColorField& lengths) {
  double largest = 0;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    const double* v = arrows.vectors.data() + 3 * i;
    largest = std::max(largest, std::hypot(v[0], v[1], v[2]));
  }
  if (!(largest > 0)) return;
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(12), arrow->SetShaftResolution(12);
  arrow->SetTipRadius(0.14), arrow->SetShaftRadius(0.05);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputData(arrow_points(frame, arrows, lengths, arrows.longest / largest));
  glyphs->SetSourceConnection(arrow->GetOutputPort());
  glyphs->SetVectorModeToUseVector();
  glyphs->SetScaleModeToScaleByVector();
  glyphs->SetColorModeToColorByScalar();
  glyphs->SetScaleFactor(1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glyphs->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.25);
  if (frame.dimension == 2)  // in front of the discs
    actor->SetPosition(0, 0, 2 * *std::max_element(frame.radius.begin(), frame.radius.end()));
  renderer->AddActor(actor);
}

}  // namespace scree::pictures
