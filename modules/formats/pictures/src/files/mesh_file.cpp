#include "mesh_file.hpp"

#include "read_apart.hpp"
#include "vtk_messages.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

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

std::string ending_of(const std::filesystem::path& file) {
  std::string end = file.extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end;
}

template <class Reader>
vtkSmartPointer<vtkPolyData> polygons(const std::filesystem::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> polygons_of(const std::filesystem::path& file) {
  const std::string end = ending_of(file);
  if (end == ".stl") return polygons<vtkSTLReader>(file);
  if (end == ".obj") return polygons<vtkOBJReader>(file);
  if (end == ".ply") return polygons<vtkPLYReader>(file);
  if (end == ".vtp") return polygons<vtkXMLPolyDataReader>(file);
  throw Error(file.string(), "is no file of triangles by its name",
              "give one that ends in .stl, .obj, .ply or .vtp");
}

// VTK takes an STL file that was cut off for a shorter one.
void check_stl(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  char head[84] = {};
  stream.read(head, sizeof(head));
  const std::string_view start(head, std::size_t(stream.gcount()));
  if (start.starts_with("solid") && start.find('\0') == start.npos) return;  // a text
  std::uint32_t count = 0;
  std::memcpy(&count, head + 80, sizeof(count));
  std::error_code failed;
  if (std::filesystem::file_size(file, failed) != 84 + 50 * std::uintmax_t(count))
    throw Error(file.string(), fmt::format("its size is not that of its {} triangles", count), give_another);
}

// VTK takes points and faces of an OBJ file that are none for others.
void check_obj(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::int64_t points = 0, largest = 0, number = 0, line_of_largest = 0;
  const auto refuse = [&](std::int64_t line, const char* problem) {
    throw Error(file.string(), fmt::format("line {} {}", line, problem), give_another);
  };
  for (std::string line; std::getline(stream, line);) {
    if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) refuse(1, "begins with a byte order mark");
    std::istringstream words(line);
    std::string word;
    words >> word;
    double x = 0, y = 0, z = 0;
    if (word == "v" && (++points, !(words >> x >> y >> z))) refuse(number, "is not a point");
    for (const bool face = word == "f"; face && words >> word;) {
      const std::int64_t corner = std::strtoll(word.c_str(), nullptr, 10);
      if (corner == 0 || corner < -points) refuse(number, "has a point that is not there");
      if (corner > largest) largest = corner, line_of_largest = number;
    }
  }
  if (largest > points) refuse(line_of_largest, "has a point that is not there");
}

void check_text(const std::filesystem::path& file) {
  if (ending_of(file) == ".stl") check_stl(file);
  if (ending_of(file) == ".obj") check_obj(file);
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

// The filter trusts the numbers of points.
bool has_its_points(vtkPolyData* mesh) {
  for (vtkCellArray* const cells : {mesh->GetPolys(), mesh->GetStrips()})
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
      vtkIdType count = 0;
      const vtkIdType* corner = nullptr;
      cells->GetCellAtId(cell, count, corner);
      for (vtkIdType k = 0; k < count; ++k)
        if (corner[k] < 0 || corner[k] >= mesh->GetNumberOfPoints()) return false;
    }
  return true;
}

std::vector<double> numbers_of(const std::filesystem::path& file) {
  check_text(file);
  VtkMessages messages;
  const vtkSmartPointer<vtkPolyData> polygons = polygons_of(file);
  if (!has_its_points(polygons))
    throw Error(file.string(), "a face has a point that is not there", give_another);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(polygons);
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
  const std::size_t count = points.all().size() / 3;
  std::vector<double> numbers = {double(count)};
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
