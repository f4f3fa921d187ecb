#include "wall_actors.hpp"

#include "wall_outline.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace scree::snapshot {
namespace {

// Unlit and translucent or thin: walls carry no data and stay behind it.
vtkProperty* add_actor(vtkRenderer* renderer, vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  return actor->GetProperty();
}

}  // namespace

void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> faces, edges;
  for (std::size_t wall = 0; wall < frame.walls.size(); ++wall) {
    const std::vector<Point> outline = wall_outline(frame, wall, box);
    if (outline.size() < 2) continue;
    const vtkIdType first = points->GetNumberOfPoints();
    const int corners = static_cast<int>(outline.size());
    for (const Point& corner : outline) points->InsertNextPoint(corner.data());
    edges->InsertNextCell(corners + 1);
    for (int k = 0; k <= corners; ++k) edges->InsertCellPoint(first + k % corners);
    if (frame.dimension == 2 || dot(frame.walls[wall].normal, axes.toward) <= 1e-9) continue;
    faces->InsertNextCell(corners);
    for (int k = 0; k < corners; ++k) faces->InsertCellPoint(first + k);
  }
  vtkNew<vtkPolyData> face_data, edge_data;
  face_data->SetPoints(points);
  face_data->SetPolys(faces);
  edge_data->SetPoints(points);
  edge_data->SetLines(edges);
  vtkProperty* face = add_actor(renderer, face_data);
  face->SetColor(0.55, 0.62, 0.70);
  face->SetOpacity(0.22);
  vtkProperty* edge = add_actor(renderer, edge_data);
  edge->SetColor(0.25, 0.28, 0.32);
  edge->SetLineWidth(static_cast<float>((frame.dimension == 2 ? 3.0 : 1.5) * pixel_scale));
}

}  // namespace scree::snapshot
