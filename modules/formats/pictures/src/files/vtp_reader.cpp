#include "pvd_index.hpp"
#include "vtk_messages.hpp"
#include "vtp.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <scree/error.hpp>
#include <scree/pictures/frame_files.hpp>

namespace scree::pictures {
namespace {

[[noreturn]] void reject(const std::filesystem::path& file, const std::string& reason) {
  throw Error(
      fmt::format("{}: {}; give a particles_<step>.vtp file that a run has written", file.string(), reason));
}

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) reject(file, "there is no such file");
  VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(file.c_str())) reject(file, "is not a VTK XML PolyData file");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (messages.has_errors() || reader->GetErrorCode() != 0) reject(file, "is damaged");
  return reader->GetOutput();
}

// Values of an array, component by component; empty if the file has no such array.
template <class T>
std::vector<T> column(vtkFieldData* fields, const char* name) {
  vtkDataArray* array = fields->GetArray(name);
  if (!array) return {};
  std::vector<T> values(std::size_t(array->GetNumberOfValues()));
  const int components = array->GetNumberOfComponents();
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
    if constexpr (std::is_floating_point_v<T>)
      values[k] = array->GetComponent(k / components, int(k % components));
    else  // via the variant: a double cannot represent every 64-bit integer
      values[k] = T(array->GetVariantValue(k).ToTypeInt64());
  return values;
}

std::vector<std::string> strings(vtkFieldData* fields, const char* name) {
  std::vector<std::string> values;
  if (auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name)))
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k) values.push_back(array->GetValue(k));
  return values;
}

std::array<double, 3> triple(const std::vector<double>& values, std::size_t index) {
  if (values.size() < 3 * index + 3) return {};
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

std::vector<double> coordinates(vtkPolyData* data) {
  std::vector<double> values(std::size_t(3 * data->GetNumberOfPoints()));
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) data->GetPoint(k, values.data() + 3 * k);
  return values;
}

void read_particles(vtkPolyData* data, Frame& frame) {
  vtkPointData* columns = data->GetPointData();
  frame.position = coordinates(data);
  frame.id = column<std::int64_t>(columns, vtp::id);
  frame.radius = column<double>(columns, vtp::radius);
  frame.material = column<std::int32_t>(columns, vtp::material);
  frame.velocity = column<double>(columns, vtp::velocity);
  frame.spin = column<double>(columns, vtp::spin);
  frame.coordination = column<std::int32_t>(columns, vtp::coordination);
  frame.force = column<double>(columns, vtp::force);
  frame.displacement = column<double>(columns, vtp::displacement);
  frame.group = column<std::int32_t>(columns, vtp::group);
}

void read_scene(vtkFieldData* fields, Frame& frame) {
  const auto step = column<std::uint64_t>(fields, vtp::step);
  const auto dimension = column<std::int32_t>(fields, vtp::dimension);
  const auto title = strings(fields, vtp::title);
  if (!step.empty()) frame.step = step[0];
  if (!dimension.empty()) frame.dimension = dimension[0];
  if (!title.empty()) frame.title = title[0];
  frame.lower = triple(column<double>(fields, vtp::lower), 0);
  frame.upper = triple(column<double>(fields, vtp::upper), 0);
  frame.groups = strings(fields, vtp::group_name);
  const auto names = strings(fields, vtp::wall_name);
  const auto points = column<double>(fields, vtp::wall_point);
  const auto normals = column<double>(fields, vtp::wall_normal);
  for (std::size_t k = 0; k < names.size(); ++k)
    frame.walls.push_back({names[k], triple(points, k), triple(normals, k)});
}

void read_contacts(vtkPolyData* data, Frame& frame) {
  const std::vector<double> ends = coordinates(data);
  for (std::size_t k = 0; k + 6 <= ends.size(); k += 6) {
    frame.contact_from.insert(frame.contact_from.end(), ends.begin() + k, ends.begin() + k + 3);
    frame.contact_to.insert(frame.contact_to.end(), ends.begin() + k + 3, ends.begin() + k + 6);
  }
  vtkCellData* columns = data->GetCellData();
  frame.contact_normal_force = column<double>(columns, vtp::normal_force);
  frame.contact_tangential_force = column<double>(columns, vtp::tangential_force);
  frame.contact_overlap = column<double>(columns, vtp::overlap);
  frame.contact_sliding = column<std::uint8_t>(columns, vtp::sliding);
  frame.contact_a = column<std::int64_t>(columns, vtp::body_a);
  frame.contact_b = column<std::int64_t>(columns, vtp::body_b);
  frame.contact_wall = column<std::int32_t>(columns, vtp::wall);
  frame.contact_normal = column<double>(columns, vtp::normal);
  frame.contact_force = column<double>(columns, vtp::force);
  frame.contact_point = column<double>(columns, vtp::point);
}

// What a cell of the file has of a map, if the file has it.
void append_cell(const std::vector<double>& all, std::size_t cell, const SurfaceMap& map, Surface& surface) {
  const std::size_t first = map.components * cell;
  if (all.size() < first + map.components) return;
  const auto from = all.begin() + std::ptrdiff_t(first);
  std::vector<double>& values = surface.*map.values;
  values.insert(values.end(), from, from + std::ptrdiff_t(map.components));
}

// Each surface with all points of the file.
void read_surfaces(vtkPolyData* data, Frame& frame) {
  const std::vector<std::string> names = strings(data->GetFieldData(), vtp::surface_name);
  const auto number = column<std::int32_t>(data->GetCellData(), vtp::surface);
  const auto force = column<double>(data->GetCellData(), vtp::force),
             torque = column<double>(data->GetCellData(), vtp::torque);
  for (const std::string& name : names) {
    Surface& surface = frame.surfaces.emplace_back();
    surface.name = name;
    surface.points = coordinates(data);
  }
  std::vector<std::vector<double>> maps;
  for (const SurfaceMap& map : surface_maps) maps.push_back(column<double>(data->GetCellData(), map.name));
  vtkCellArray* const cells = frame.dimension == 2 ? data->GetLines() : data->GetPolys();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    cells->GetCellAtId(cell, count, corner);
    const auto c = std::size_t(cell);
    if (c >= number.size() || number[c] < 0 || std::size_t(number[c]) >= names.size() ||
        count != frame.dimension)
      continue;
    Surface& surface = frame.surfaces[std::size_t(number[c])];
    surface.cells.insert(surface.cells.end(), corner, corner + count);
    surface.force = triple(force, c), surface.torque = triple(torque, c);
    for (std::size_t m = 0; m < maps.size(); ++m) append_cell(maps[m], c, surface_maps[m], surface);
  }
}

double read_time(vtkFieldData* fields, const std::filesystem::path& particles_file) {
  const auto time = column<double>(fields, vtp::time);
  if (!time.empty()) return time[0];
  return PvdIndex(particles_file.parent_path() / "particles.pvd")
      .time_of(particles_file.filename())
      .value_or(0);
}

}  // namespace

Frame read_vtp(const std::filesystem::path& particles_file) {
  const std::string prefix = "particles";
  const std::string name = particles_file.filename();
  const auto particles = read_poly_data(particles_file);
  Frame frame;
  read_particles(particles, frame);
  read_scene(particles->GetFieldData(), frame);
  frame.time = read_time(particles->GetFieldData(), particles_file);
  const bool of_particles =
      particles->GetPointData()->HasArray(vtp::id) && particles->GetPointData()->HasArray(vtp::radius);
  if (!of_particles || frame.position.size() != 3 * frame.radius.size() ||
      frame.id.size() != frame.radius.size())
    reject(particles_file, "has no radius or no id for each particle");
  if (!name.starts_with(prefix)) return frame;
  const auto contacts_file = particles_file.parent_path() / ("contacts" + name.substr(prefix.size()));
  if (std::filesystem::exists(contacts_file)) read_contacts(read_poly_data(contacts_file), frame);
  const auto surfaces_file = particles_file.parent_path() / (surface_kind + name.substr(prefix.size()));
  if (std::filesystem::exists(surfaces_file)) read_surfaces(read_poly_data(surfaces_file), frame);
  return frame;
}

}  // namespace scree::pictures
