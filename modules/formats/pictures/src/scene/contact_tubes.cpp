#include "contact_tubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <scree/charts/scaled_unit.hpp>

namespace scree::pictures {
namespace {

constexpr std::uint8_t sticking_color[3] = {30, 30, 30};
constexpr std::uint8_t sliding_color[3] = {214, 39, 40};

double largest_normal_force(const Frame& frame) {
  double largest = 0;
  for (double force : frame.contact_normal_force) largest = std::max(largest, std::abs(force));
  return largest;
}

double mean_radius(const Frame& frame) {
  return std::accumulate(frame.radius.begin(), frame.radius.end(), 0.0) / double(frame.radius.size());
}

// Radius of a bar (m): a fraction of the mean particle radius, with a visible minimum.
double bar_radius(double force, double largest_force, double mean, int dimension) {
  const double fraction = largest_force > 0 ? std::abs(force) / largest_force : 0;
  return mean * (dimension == 2 ? std::max(0.015, 0.15 * fraction) : std::max(0.015, 0.18 * fraction));
}

double mean_normal_force(const Frame& frame) {
  return std::accumulate(frame.contact_normal_force.begin(), frame.contact_normal_force.end(), 0.0) /
         double(frame.contact_count());
}

// From yellow at the mean force over red to black at the largest.
std::array<std::uint8_t, 3> chain_color(double force, double mean, double largest) {
  static constexpr double map[3][3] = {{250, 190, 60}, {214, 39, 40}, {60, 0, 20}};
  const double place = largest > mean ? 2 * std::clamp((force - mean) / (largest - mean), 0.0, 1.0) : 2;
  const int knot = std::min(int(place), 1);
  std::array<std::uint8_t, 3> color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = std::uint8_t(std::lround(std::lerp(map[knot][k], map[knot + 1][k], place - knot)));
  return color;
}

vtkNew<vtkPolyData> contact_lines(const Frame& frame, bool strong) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  const double largest = largest_normal_force(frame);
  const double mean = mean_radius(frame), mean_force = mean_normal_force(frame);
  for (std::size_t k = 0; k < frame.contact_count(); ++k) {
    const double* from = frame.contact_from.data() + 3 * k;
    const double* to = frame.contact_to.data() + 3 * k;
    if (std::equal(from, from + 3, to)) continue;  // a bar needs a direction
    const double force = frame.contact_normal_force[k];
    if (strong && !(force > mean_force)) continue;
    const std::array<std::uint8_t, 3> chain = chain_color(force, mean_force, largest);
    const std::uint8_t* const color = strong                     ? chain.data()
                                      : frame.contact_sliding[k] ? sliding_color
                                                                 : sticking_color;
    lines->InsertNextCell(2);
    for (const double* end : {from, to}) {
      lines->InsertCellPoint(points->InsertNextPoint(end));
      radii->InsertNextValue(bar_radius(force, largest, mean, frame.dimension));
      colors->InsertNextTypedTuple(color);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetScalars(radii);
  data->GetPointData()->AddArray(colors);
  return data;
}

}  // namespace

void add_contacts(vtkRenderer* renderer, const Frame& frame, bool strong) {
  if (frame.contact_count() == 0 || frame.radius.empty()) return;
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(contact_lines(frame, strong));
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("color");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  if (frame.dimension == 2) {
    actor->GetProperty()->LightingOff();
    actor->SetPosition(
        0, 0, 1.5 * *std::max_element(frame.radius.begin(), frame.radius.end()));  // in front of the discs
  }
  renderer->AddActor(actor);
}

std::string contact_note(const Frame& frame, bool strong) {
  if (frame.contact_count() == 0) return "no contacts";
  const double largest = largest_normal_force(frame);
  const charts::ScaledUnit unit = charts::scaled_unit(largest, "N");
  if (strong)
    return fmt::format(
        "bars: contacts above the mean normal force of {:.3g} {}; dark: the largest, {:.3g} {}",
        mean_normal_force(frame) * unit.factor, unit.symbol, largest * unit.factor, unit.symbol);
  const bool any_slides = std::count(frame.contact_sliding.begin(), frame.contact_sliding.end(), 0) !=
                          std::ptrdiff_t(frame.contact_sliding.size());
  return fmt::format("bars: contacts, width proportional to normal force, widest {:.3g} {}{}",
                     largest * unit.factor, unit.symbol, any_slides ? "; red: sliding" : "");
}

}  // namespace scree::pictures
