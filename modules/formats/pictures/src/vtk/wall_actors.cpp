#include "wall_actors.hpp"

#include "flat_actor.hpp"
#include "wall_outline.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

namespace scree::pictures {

void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> faces, edges;
  for (std::size_t wall = 0; wall < frame.walls.size(); ++wall) {
    const std::vector<Point> outline = wall_outline(frame, wall, box);
    if (outline.size() < 2) continue;
    const vtkIdType first = points->GetNumberOfPoints();
    const int corners = int(outline.size());
    for (const Point& corner : outline) points->InsertNextPoint(corner.data());
    edges->InsertNextCell(corners + 1);
    for (int k = 0; k <= corners; ++k) edges->InsertCellPoint(first + k % corners);
    if (frame.dimension == 2 || dot(frame.walls[wall].normal, axes.toward) <= 1e-9) continue;
    faces->InsertNextCell(corners);
    for (int k = 0; k < corners; ++k) faces->InsertCellPoint(first + k);
  }
  // Translucent faces and thin edges, drawn flat: walls must not hide the data behind them.
  vtkNew<vtkPolyData> face_data, edge_data;
  face_data->SetPoints(points);
  face_data->SetPolys(faces);
  edge_data->SetPoints(points);
  edge_data->SetLines(edges);
  vtkProperty* face = add_flat_actor(renderer, face_data);
  face->SetColor(0.55, 0.62, 0.70);
  face->SetOpacity(0.22);
  vtkProperty* edge = add_flat_actor(renderer, edge_data);
  edge->SetColor(0.25, 0.28, 0.32);
  edge->SetLineWidth(float((frame.dimension == 2 ? 3.0 : 1.5) * pixel_scale));
}

}  // namespace scree::pictures
