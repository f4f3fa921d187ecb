#include "mesh_file.hpp"

#include "read_apart.hpp"
#include "vtk_messages.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <map>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

namespace scree::pictures {
namespace {

constexpr const char* give_another = "give a whole STL, OBJ, PLY or VTP file with triangles";

template <class Reader>
vtkSmartPointer<vtkPolyData> polygons(const std::filesystem::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> polygons_of(const std::filesystem::path& file) {
  std::string end = file.extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  if (end == ".stl") return polygons<vtkSTLReader>(file);
  if (end == ".obj") return polygons<vtkOBJReader>(file);
  if (end == ".ply") return polygons<vtkPLYReader>(file);
  if (end == ".vtp") return polygons<vtkXMLPolyDataReader>(file);
  throw Error(file.string(), "is no file of triangles by its name",
              "give one that ends in .stl, .obj, .ply or .vtp");
}

// Numbers of points, of which those with the same coordinates are one.
class Points {
 public:
  std::uint32_t number_of(const std::array<double, 3>& x) {
    std::array<std::uint64_t, 3> bits;
    for (std::size_t k = 0; k < 3; ++k) bits[k] = std::bit_cast<std::uint64_t>(x[k] == 0 ? 0.0 : x[k]);
    const auto [known, added] = numbers_.try_emplace(bits, std::uint32_t(numbers_.size()));
    if (added) all_.insert(all_.end(), x.begin(), x.end());
    return known->second;
  }
  const std::vector<double>& all() const { return all_; }

 private:
  std::map<std::array<std::uint64_t, 3>, std::uint32_t> numbers_;
  std::vector<double> all_;
};

std::vector<double> numbers_of(const std::filesystem::path& file) {
  VtkMessages messages;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(polygons_of(file));
  triangles->PassVertsOff(), triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* const mesh = triangles->GetOutput();
  if (messages.has_errors() || mesh->GetNumberOfPolys() == 0)
    throw Error(file.string(), messages.has_errors() ? "is damaged" : "has no triangles", give_another);
  Points points;
  std::vector<double> corners;
  vtkCellArray* const cells = mesh->GetPolys();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    cells->GetCellAtId(cell, count, corner);
    for (vtkIdType k = 0; k < count; ++k) {
      std::array<double, 3> x;
      mesh->GetPoint(corner[k], x.data());
      corners.push_back(points.number_of(x));
    }
  }
  std::vector<double> numbers = {double(points.all().size() / 3)};
  numbers.insert(numbers.end(), points.all().begin(), points.all().end());
  numbers.insert(numbers.end(), corners.begin(), corners.end());
  return numbers;
}

}  // namespace

std::vector<double> read_mesh_file(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    throw Error(file.string(), "there is no such file", "give its name relative to the scenario");
  const std::string sent =
      read_apart(file, Error(file.string(), "is damaged", give_another), [&](const Send& send) {
        const std::vector<double> numbers = numbers_of(file);
        send({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
      });
  std::vector<double> numbers(sent.size() / sizeof(double));
  std::memcpy(numbers.data(), sent.data(), numbers.size() * sizeof(double));
  return numbers;
}

}  // namespace scree::pictures
