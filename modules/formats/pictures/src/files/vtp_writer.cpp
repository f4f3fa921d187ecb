#include "body_stress.hpp"
#include "vtp.hpp"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt64Array.h>
#include <vtkTypeUInt8Array.h>
#include <vtkXMLPolyDataWriter.h>

namespace scree::pictures {
namespace {

template <class Array, class T>
void add_column(vtkFieldData* fields, const char* name, const std::vector<T>& values, int components = 1) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(vtkIdType(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  fields->AddArray(array);
}

// A column that the scene lacks is omitted from the file.
template <class Array, class T>
void add_carried_column(vtkFieldData* fields, const char* name, const std::vector<T>& values,
                        int components = 1) {
  if (!values.empty()) add_column<Array>(fields, name, values, components);
}

void add_strings(vtkFieldData* fields, const char* name, const std::vector<std::string>& values) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values) array->InsertNextValue(value);
  fields->AddArray(array);
}

std::vector<double> triple(const std::array<double, 3>& value) { return {value.begin(), value.end()}; }

void add_walls(vtkFieldData* fields, const std::vector<Wall>& walls) {
  std::vector<std::string> names;
  std::vector<double> points, normals;
  for (const Wall& wall : walls) {
    names.push_back(wall.name);
    points.insert(points.end(), wall.point.begin(), wall.point.end());
    normals.insert(normals.end(), wall.normal.begin(), wall.normal.end());
  }
  add_strings(fields, vtp::wall_name, names);
  add_column<vtkDoubleArray>(fields, vtp::wall_point, points, 3);
  add_column<vtkDoubleArray>(fields, vtp::wall_normal, normals, 3);
}

void add_scene(vtkFieldData* fields, const Frame& frame) {
  add_column<vtkDoubleArray>(fields, vtp::time, std::vector{frame.time});
  add_column<vtkTypeUInt64Array>(fields, vtp::step, std::vector{frame.step});
  add_column<vtkTypeInt32Array>(fields, vtp::dimension, std::vector{frame.dimension});
  add_strings(fields, vtp::title, {frame.title});
  add_column<vtkDoubleArray>(fields, vtp::lower, triple(frame.lower), 3);
  add_column<vtkDoubleArray>(fields, vtp::upper, triple(frame.upper), 3);
  if (!frame.walls.empty()) add_walls(fields, frame.walls);
  if (!frame.groups.empty()) add_strings(fields, vtp::group_name, frame.groups);
}

// Cells of `size` consecutive points.
vtkNew<vtkCellArray> consecutive_cells(vtkIdType cells, vtkIdType size) {
  vtkNew<vtkCellArray> array;
  array->AllocateExact(cells, cells * size);
  for (vtkIdType cell = 0; cell < cells; ++cell) {
    array->InsertNextCell(int(size));
    for (vtkIdType k = 0; k < size; ++k) array->InsertCellPoint(cell * size + k);
  }
  return array;
}

std::string serialise(vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOn();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

// What the cells of all surfaces have; left out if a surface lacks it.
void add_map(vtkFieldData* columns, const Frame& frame, const SurfaceMap& map) {
  std::vector<double> all;
  for (const Surface& s : frame.surfaces) {
    const std::vector<double>& values = s.*map.values;
    if (values.size() != map.components * (s.cells.size() / std::size_t(frame.dimension))) return;
    all.insert(all.end(), values.begin(), values.end());
  }
  add_column<vtkDoubleArray>(columns, map.name, all, int(map.components));
}

}  // namespace

std::string particles_vtp(const Frame& frame) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vtkIdType(frame.particle_count()));
  std::copy(frame.position.begin(), frame.position.end(), static_cast<double*>(points->GetVoidPointer(0)));
  data->SetPoints(points);
  data->SetVerts(consecutive_cells(points->GetNumberOfPoints(), 1));
  vtkPointData* columns = data->GetPointData();
  add_column<vtkTypeInt64Array>(columns, vtp::id, frame.id);
  add_column<vtkDoubleArray>(columns, vtp::radius, frame.radius);
  add_carried_column<vtkTypeInt32Array>(columns, vtp::material, frame.material);
  add_carried_column<vtkDoubleArray>(columns, vtp::velocity, frame.velocity, 3);
  add_carried_column<vtkDoubleArray>(columns, vtp::spin, frame.spin, 3);
  add_carried_column<vtkTypeInt32Array>(columns, vtp::coordination, frame.coordination);
  add_carried_column<vtkDoubleArray>(columns, vtp::force, frame.force, 3);
  add_carried_column<vtkDoubleArray>(columns, vtp::displacement, frame.displacement, 3);
  add_carried_column<vtkTypeInt32Array>(columns, vtp::group, frame.group);
  if (!frame.contact_force.empty())
    add_carried_column<vtkDoubleArray>(columns, vtp::stress, stresses(frame), 6);
  add_scene(data->GetFieldData(), frame);
  return serialise(data);
}

std::string contacts_vtp(const Frame& frame) {
  const vtkIdType contacts = vtkIdType(frame.contact_count());
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(2 * contacts);
  for (vtkIdType k = 0; k < contacts; ++k) {
    points->SetPoint(2 * k, frame.contact_from.data() + 3 * k);
    points->SetPoint(2 * k + 1, frame.contact_to.data() + 3 * k);
  }
  data->SetPoints(points);
  data->SetLines(consecutive_cells(contacts, 2));
  vtkCellData* columns = data->GetCellData();
  add_column<vtkDoubleArray>(columns, vtp::normal_force, frame.contact_normal_force);
  add_column<vtkDoubleArray>(columns, vtp::tangential_force, frame.contact_tangential_force);
  add_column<vtkDoubleArray>(columns, vtp::overlap, frame.contact_overlap);
  add_column<vtkTypeUInt8Array>(columns, vtp::sliding, frame.contact_sliding);
  add_carried_column<vtkTypeInt64Array>(columns, vtp::body_a, frame.contact_a);
  add_carried_column<vtkTypeInt64Array>(columns, vtp::body_b, frame.contact_b);
  add_carried_column<vtkTypeInt32Array>(columns, vtp::wall, frame.contact_wall);
  add_carried_column<vtkDoubleArray>(columns, vtp::normal, frame.contact_normal, 3);
  add_carried_column<vtkDoubleArray>(columns, vtp::force, frame.contact_force, 3);
  add_carried_column<vtkDoubleArray>(columns, vtp::point, frame.contact_point, 3);
  add_column<vtkDoubleArray>(data->GetFieldData(), vtp::time, std::vector{frame.time});
  if (!frame.walls.empty()) add_walls(data->GetFieldData(), frame.walls);
  return serialise(data);
}

// Forces and torques are those of all contacts of a surface, the same in all its cells.
std::string surfaces_vtp(const Frame& frame) {
  const vtkIdType corners = frame.dimension;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<std::int32_t> number;
  std::vector<double> force, torque;
  std::vector<std::string> names;
  for (const Surface& s : frame.surfaces) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t p = 0; p + 3 <= s.points.size(); p += 3) points->InsertNextPoint(s.points.data() + p);
    for (std::size_t c = 0; c < s.cells.size(); ++c) {
      if (c % std::size_t(corners) == 0) {
        cells->InsertNextCell(int(corners));
        number.push_back(std::int32_t(names.size()));
        force.insert(force.end(), s.force.begin(), s.force.end());
        torque.insert(torque.end(), s.torque.begin(), s.torque.end());
      }
      cells->InsertCellPoint(first + s.cells[c]);
    }
    names.push_back(s.name);
  }
  data->SetPoints(points);
  frame.dimension == 2 ? data->SetLines(cells) : data->SetPolys(cells);
  vtkCellData* columns = data->GetCellData();
  add_column<vtkTypeInt32Array>(columns, vtp::surface, number);
  add_column<vtkDoubleArray>(columns, vtp::force, force, 3);
  add_column<vtkDoubleArray>(columns, vtp::torque, torque, 3);
  for (const SurfaceMap& map : surface_maps) add_map(columns, frame, map);
  add_strings(data->GetFieldData(), vtp::surface_name, names);
  add_scene(data->GetFieldData(), frame);
  return serialise(data);
}

}  // namespace scree::pictures
