#include "particle_actors.hpp"

#include "flat_actor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace scree::pictures {
namespace {

// Inserts the corners of the polygon that approximates a disc; `lift` (m): height towards the viewer.
void insert_circle(vtkPoints* points, const Frame& frame, std::size_t disc, int corners, double lift) {
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points->InsertNextPoint(frame.position[3 * disc] + frame.radius[disc] * std::cos(angle),
                            frame.position[3 * disc + 1] + frame.radius[disc] * std::sin(angle), lift);
  }
}

}  // namespace

void add_spheres(vtkRenderer* renderer, const Frame& frame, const ColorField& field,
                 const std::vector<std::size_t>& particles, double scale) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;  // required: the mapper draws only points with cells
  vtkNew<vtkFloatArray>
      radii;  // float, because the mapper reads this column as float without checking its type
  radii->SetName("radius");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t particle : particles) {
    const vtkIdType point = points->InsertNextPoint(frame.position.data() + 3 * particle);
    vertices->InsertNextCell(1, &point);
    radii->InsertNextValue(float(scale * frame.radius[particle]));
    colors->InsertNextTypedTuple(field.color(particle).data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("radius");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetDiffuse(0.88);
  renderer->AddActor(actor);
}

void add_discs(vtkRenderer* renderer, const Frame& frame, const ColorField& field, int pixel_scale) {
  const int corners = frame.particle_count() <= 2000 ? 72 : 24;
  const double largest =
      frame.radius.empty() ? 0 : *std::max_element(frame.radius.begin(), frame.radius.end());
  vtkNew<vtkPoints> fill_points, rim_points;
  vtkNew<vtkCellArray> fills, rims;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t disc = 0; disc < frame.particle_count(); ++disc) {
    colors->InsertNextTypedTuple(field.color(disc).data());
    // Viewed from above, the height only sets the drawing order: discs by number, then rims.
    insert_circle(fill_points, frame, disc, corners, largest * double(disc) / double(frame.particle_count()));
    insert_circle(rim_points, frame, disc, corners, 1.1 * largest);
    const vtkIdType first = vtkIdType(disc) * corners;
    fills->InsertNextCell(corners);
    rims->InsertNextCell(corners + 1);
    for (int k = 0; k < corners; ++k) fills->InsertCellPoint(first + k);
    for (int k = 0; k <= corners; ++k) rims->InsertCellPoint(first + k % corners);
  }
  vtkNew<vtkPolyData> fill_data, rim_data;
  fill_data->SetPoints(fill_points);
  fill_data->SetPolys(fills);
  fill_data->GetCellData()->SetScalars(colors);
  rim_data->SetPoints(rim_points);
  rim_data->SetLines(rims);
  add_flat_actor(renderer, fill_data);
  vtkProperty* rim = add_flat_actor(renderer, rim_data);
  const double grey = field.paleness > 0 ? 0.6 : 0.1;
  rim->SetColor(grey, grey, grey);
  rim->SetLineWidth(float((frame.particle_count() <= 2000 ? 1.25 : 0.6) * pixel_scale));
}

}  // namespace scree::pictures
