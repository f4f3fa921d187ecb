#include "particle_actors.hpp"

#include "flat_actor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
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
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

namespace scree::pictures {
namespace {

// The polygon that approximates a disc.
std::vector<Point> circle(const Frame& frame, std::size_t disc, int corners) {
  std::vector<Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back({frame.position[3 * disc] + frame.radius[disc] * std::cos(angle),
                      frame.position[3 * disc + 1] + frame.radius[disc] * std::sin(angle), 0});
  }
  return points;
}

// Adds a polygon at a height (m) towards the viewer, of which the last corner may be repeated.
void insert_polygon(vtkPoints* points, vtkCellArray* cells, const std::vector<Point>& corners, double height,
                    bool closed) {
  const vtkIdType first = points->GetNumberOfPoints();
  const int count = int(corners.size());
  for (const Point& corner : corners) points->InsertNextPoint(corner[0], corner[1], height);
  cells->InsertNextCell(count + closed);
  for (int k = 0; k < count + closed; ++k) cells->InsertCellPoint(first + k % count);
}

// Fragment shader, between the point where a ray along -z meets a sphere and its depth: the ray is shortened
// to the part in the half-spaces. A face has the normal of its plane and a dark edge.
std::string shortened_ray(const SphereCut& cut) {
  std::string code =
      "  float shade_of_cut = 1.0, front = vertexVC.z, back = 2.0 * centerVCVSOutput.z - vertexVC.z;\n"
      "  vec4 face = vec4(0.0);\n";
  for (const auto& [normal, offset] : cut.spaces) {
    const std::string rest =
        fmt::format("({:.9e} - {:.9e} * vertexVC.x - {:.9e} * vertexVC.y)", offset, normal[0], normal[1]);
    const std::string height = fmt::format("{} / {:.9e}", rest, normal[2]);
    if (std::abs(normal[2]) < 1e-6)
      code += fmt::format("  if ({} > 0.0) discard;\n", rest);
    else if (normal[2] > 0)
      code += fmt::format("  back = max(back, {});\n", height);
    else
      code += fmt::format(
          "  if ({0} < front) {{ front = {0}; face = vec4({1:.9e}, {2:.9e}, {3:.9e}, {4:.9e}); }}\n", height,
          -normal[0], -normal[1], -normal[2], -offset);
  }
  // The face is a disc of radius sqrt(R^2 - d^2), at the distance d of the plane from the centre.
  return code + fmt::format(
                    "  if (front <= back) discard;\n"
                    "  if (face != vec4(0.0)) {{\n"
                    "    vertexVC.z = front;\n"
                    "    normalVCVSOutput = face.xyz;\n"
                    "    float apart = face.w - dot(face.xyz, centerVCVSOutput);\n"
                    "    float edge = sqrt(max(0.0, radiusVCVSOutput * radiusVCVSOutput - apart * apart));\n"
                    "    float place = length(vertexVC.xyz - centerVCVSOutput - apart * face.xyz);\n"
                    "    if (place > edge - {:.9e}) shade_of_cut = 0.35;\n"
                    "  }}\n",
                    cut.rim);
}

void cut_spheres(vtkActor* actor, const SphereCut& cut) {
  if (cut.spaces.empty()) return;
  const std::string depth = "  vec4 pos = VCDCMatrix * vertexVC;\n", normal = "//VTK::Normal::Impl";
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddFragmentShaderReplacement(depth, false, shortened_ray(cut) + depth, false);
  shader->AddFragmentShaderReplacement(
      normal, true, "  diffuseColor *= shade_of_cut;\n  ambientColor *= shade_of_cut;\n" + normal, false);
}

// Bodies have no highlights, which VTK computes all the same: two powers per pixel drawn.
void skip_highlights(vtkActor* actor) {
  for (int light = 0; light < scene_lights; ++light)
    actor->GetShaderProperty()->AddFragmentShaderReplacement(
        fmt::format("  sf = sign(df)*pow(max(0.0, dot( reflect(lightDirectionVC{}, normalVCVSOutput), "
                    "normalize(-vertexVC.xyz))), specularPower);\n",
                    light),
        false, "  sf = 0.0;\n", false);
}

}  // namespace

void add_spheres(vtkRenderer* renderer, const Frame& frame, const ColorField& field,
                 const std::vector<std::size_t>& particles, double scale, const SphereCut& cut) {
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
  skip_highlights(actor);
  cut_spheres(actor, cut);
  renderer->AddActor(actor);
}

void add_discs(vtkRenderer* renderer, const Frame& frame, const ColorField& field, int pixel_scale,
               const std::vector<HalfSpace>& cut) {
  const int corners = frame.particle_count() <= 2000 ? 72 : 24;
  const double largest =
      frame.radius.empty() ? 0 : *std::max_element(frame.radius.begin(), frame.radius.end());
  vtkNew<vtkPoints> fill_points, rim_points;
  vtkNew<vtkCellArray> fills, rims;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t disc = 0; disc < frame.particle_count(); ++disc) {
    std::vector<Point> outline = circle(frame, disc, corners);
    for (const HalfSpace& space : cut) outline = clipped(outline, space);
    if (outline.size() < 3) continue;
    colors->InsertNextTypedTuple(field.color(disc).data());
    // Viewed from above, the height only sets the drawing order: discs by number, then rims.
    insert_polygon(fill_points, fills, outline, largest * double(disc) / double(frame.particle_count()),
                   false);
    insert_polygon(rim_points, rims, outline, 1.1 * largest, true);
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
