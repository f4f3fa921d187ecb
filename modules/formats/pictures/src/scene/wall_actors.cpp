#include "wall_actors.hpp"

#include "files/vtp.hpp"
#include "flat_actor.hpp"
#include "half_space.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/error.hpp>

namespace scree::pictures {
namespace {

void set_face_look(vtkProperty* face) {
  face->SetColor(0.55, 0.62, 0.70);
  face->SetOpacity(0.22);
}
void set_edge_look(vtkProperty* edge, double pixels) {
  edge->SetColor(0.25, 0.28, 0.32);
  edge->SetLineWidth(float(pixels));
}

// Part of the plane around the box, larger than the box.
std::vector<Point> wide_patch(const Wall& wall, const SceneBox& box, int dimension) {
  const Point center = box.center();
  const double height = dot(wall.normal, moved(center, -1, wall.point));
  const Point foot = moved(center, -height, wall.normal);
  const double size = box.diagonal();
  if (dimension == 2) {
    const Point along = {-wall.normal[1], wall.normal[0], 0};
    return {moved(foot, -size, along), moved(foot, size, along)};
  }
  const Point helper = std::abs(wall.normal[2]) < 0.9 ? Point{0, 0, 1} : Point{1, 0, 0};
  const Point u = normalised(cross(helper, wall.normal));
  const Point v = cross(wall.normal, u);
  return {moved(moved(foot, -size, u), -size, v), moved(moved(foot, size, u), -size, v),
          moved(moved(foot, size, u), size, v), moved(moved(foot, -size, u), size, v)};
}

// Corners of the part of wall number `index` that lies within the box and on the inner side of the other
// walls: a polygon in 3D, the two ends of a line (possibly repeated) in 2D, empty if no part does.
std::vector<Point> wall_outline(const Frame& frame, std::size_t index, const SceneBox& box) {
  // The slack keeps walls that coincide with a face of the box or with each other.
  const double slack = 1e-6 * box.diagonal();
  std::vector<Point> outline = wide_patch(frame.walls[index], box, frame.dimension);
  for (int k = 0; k < frame.dimension; ++k) {
    Point axis{};
    axis[k] = 1;
    outline = clipped(outline, {axis, box.lower[k] - slack});
    axis[k] = -1;
    outline = clipped(outline, {axis, -box.upper[k] - slack});
  }
  for (std::size_t other = 0; other < frame.walls.size(); ++other)
    if (other != index)
      outline = clipped(outline, {frame.walls[other].normal,
                                  dot(frame.walls[other].normal, frame.walls[other].point) - slack});
  return outline;
}

// The values of a map for the cells of a surface; none if no map is shown.
const std::vector<double>& values_of(const Surface& surface, const std::string& map) {
  static const std::vector<double> none;
  for (const SurfaceMap& known : surface_maps)
    if (map == known.name) return surface.*known.values;
  return none;
}

double largest_of(const Frame& frame, const std::string& map) {
  double largest = 0;
  for (const Surface& surface : frame.surfaces)
    for (const double value : values_of(surface, map)) largest = std::max(largest, value);
  return largest;
}

// From pale yellow to dark red.
void insert_color(vtkUnsignedCharArray* colors, double share) {
  constexpr double pale[3] = {253, 224, 160}, dark[3] = {150, 0, 40};
  unsigned char color[3];
  for (int k = 0; k < 3; ++k)
    color[k] = static_cast<unsigned char>(std::lround(pale[k] + share * (dark[k] - pale[k])));
  colors->InsertNextTypedTuple(color);
}

// Facets with values above 0. Opaque: the order in which they are drawn does not matter.
void add_colored_cells(vtkRenderer* renderer, const Frame& frame, const std::string& map, int pixel_scale) {
  const double largest = largest_of(frame, map);
  const auto corners = std::size_t(frame.dimension);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const Surface& surface : frame.surfaces) {
    const std::vector<double>& values = values_of(surface, map);
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      if (!(values[cell] > 0)) continue;
      cells->InsertNextCell(frame.dimension);
      for (std::size_t k = 0; k < corners; ++k)
        cells->InsertCellPoint(
            points->InsertNextPoint(surface.points.data() + 3 * surface.cells[corners * cell + k]));
      insert_color(colors, values[cell] / largest);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  frame.dimension == 2 ? data->SetLines(cells) : data->SetPolys(cells);
  data->GetCellData()->SetScalars(colors);
  add_flat_actor(renderer, data)->SetLineWidth(float(6 * pixel_scale));
}

// Surfaces of any shape: translucent, with lines where they end or bend sharply, in 2D as lines.
void add_surfaces(vtkRenderer* renderer, const Frame& frame, int pixel_scale) {
  constexpr double sharp_degrees = 20;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Surface& surface : frame.surfaces) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t p = 0; p + 3 <= surface.points.size(); p += 3)
      points->InsertNextPoint(surface.points.data() + p);
    for (std::size_t c = 0; c < surface.cells.size(); ++c) {
      if (c % std::size_t(frame.dimension) == 0) cells->InsertNextCell(frame.dimension);
      cells->InsertCellPoint(first + surface.cells[c]);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  if (frame.dimension == 2) {
    data->SetLines(cells);
    return set_edge_look(add_flat_actor(renderer, data), 3 * pixel_scale);
  }
  data->SetPolys(cells);
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputData(data);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(joined->GetOutputPort());
  edges->SetFeatureAngle(sharp_degrees);
  edges->ColoringOff();
  edges->NonManifoldEdgesOff();
  edges->Update();
  set_face_look(add_flat_actor(renderer, data));
  set_edge_look(add_flat_actor(renderer, edges->GetOutput()), 1.5 * pixel_scale);
}

}  // namespace

std::string surface_note(const Frame& frame, const std::string& map) {
  if (map == "none") return "";
  for (const Surface& surface : frame.surfaces)
    if (values_of(surface, map).empty())
      throw Error(fmt::format("color_surfaces_by: these snapshots have no {0}; run the scene {1}", map,
                              map == vtp::sliding_work ? "with sliding_work = true in [snapshot]" : "again"));
  if (frame.surfaces.empty()) return "no surfaces";
  const charts::ScaledUnit unit =
      charts::scaled_unit(largest_of(frame, map), map == vtp::sliding_work ? "J/m^2" : "Pa");
  std::string words = map;
  std::replace(words.begin(), words.end(), '_', ' ');
  return fmt::format("surfaces: {}, darkest {:.3g} {}", words, largest_of(frame, map) * unit.factor,
                     unit.symbol);
}

void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale, const std::string& map) {
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
  set_face_look(add_flat_actor(renderer, face_data));
  set_edge_look(add_flat_actor(renderer, edge_data), (frame.dimension == 2 ? 3.0 : 1.5) * pixel_scale);
  if (!frame.surfaces.empty()) add_surfaces(renderer, frame, pixel_scale);
  if (map != "none") add_colored_cells(renderer, frame, map, pixel_scale);
}

}  // namespace scree::pictures
