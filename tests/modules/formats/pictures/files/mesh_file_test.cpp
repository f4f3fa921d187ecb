#include "sample_frame.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

// Meshes in files of several formats.

using namespace scree::pictures;
using Catch::Contains;

namespace {

// A tetrahedron with legs of 2, 3 and 4 m; four points, faces outwards.
const std::vector<std::vector<double>> corners = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
const std::vector<std::vector<std::size_t>> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::size_t p : face)
      text += "vertex " + std::to_string(corners[p][0]) + ' ' + std::to_string(corners[p][1]) + ' ' +
              std::to_string(corners[p][2]) + '\n';
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

void append(std::string& bytes, const void* value, std::size_t size) {
  bytes.append(static_cast<const char*>(value), size);
}

std::string binary_stl(float third_x = 0) {
  std::string bytes(80, ' ');
  const auto count = std::uint32_t(faces.size());
  append(bytes, &count, 4);
  for (const auto& face : faces) {
    const float normal[3] = {};
    append(bytes, normal, 12);
    for (const std::size_t p : face)
      for (std::size_t k = 0; k < 3; ++k) {
        const float x = p == 2 && k == 0 ? third_x : float(corners[p][k]);
        append(bytes, &x, 4);
      }
    bytes.append(2, '\0');
  }
  return bytes;
}

const std::string obj = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 3 0\n0 0 4\n"
    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string vtp =
    "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
    "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"4\">"
    "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
    "0 0 0 2 0 0 0 3 0 0 0 4</DataArray></Points><Polys>"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 0 3 2 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray></Polys></Piece></PolyData></VTKFile>";

std::string with(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

// Volume (m³) of a closed mesh.
double volume_of(const std::vector<double>& numbers) {
  const auto points = std::size_t(numbers[0]);
  const auto point = [&](std::size_t corner) {
    return numbers.data() + 1 + 3 * std::size_t(numbers[1 + 3 * points + corner]);
  };
  double sum = 0;
  for (std::size_t t = 0; 1 + 3 * points + 3 * t < numbers.size(); ++t) {
    const double *a = point(3 * t), *b = point(3 * t + 1), *c = point(3 * t + 2);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

}  // namespace

TEST_CASE("triangles of STL, OBJ, PLY and VTP files are read with common corners", "[snapshot]") {
  const ScratchDirectory directory;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.stl", ascii_stl()}, {"b.STL", binary_stl()}, {"c.obj", obj}, {"d.ply", ply}, {"e.vtp", vtp}};
  for (const auto& [name, content] : files) {
    INFO(name);
    std::ofstream(directory / name, std::ios::binary) << content;
    const std::vector<double> numbers = backend().read_mesh(directory / name);
    REQUIRE(numbers.size() == 1 + 3 * 4 + 3 * 4);
    CHECK(numbers[0] == 4);
    CHECK(volume_of(numbers) == 4);
  }
}

TEST_CASE("polygons of a mesh file are divided", "[snapshot]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "square.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  CHECK(backend().read_mesh(directory / "square.obj").size() == 1 + 3 * 4 + 3 * 2);
}

TEST_CASE("files that are no meshes are refused by name", "[snapshot]") {
  const ScratchDirectory directory;
  const auto refusal = [&](const std::string& name, const std::string& content) {
    if (!content.empty()) std::ofstream(directory / name, std::ios::binary) << content;
    return error_of([&] { backend().read_mesh(directory / name); });
  };
  CHECK_THAT(refusal("absent.stl", ""), Contains("absent.stl: there is no such file"));
  CHECK_THAT(refusal("mesh.txt", "v 0 0 0\n"), Contains("ends in .stl, .obj, .ply or .vtp"));
  CHECK_THAT(refusal("points.obj", "v 0 0 0\nv 1 0 0\n"), Contains("has no triangles"));
  CHECK_THAT(refusal("word.stl", "hello\n"), Contains("word.stl: "));
  CHECK_THAT(refusal("cut.vtp", vtp.substr(0, vtp.size() / 2)), Contains("cut.vtp: is damaged"));
  CHECK_THAT(refusal("cut.ply", ply.substr(0, ply.size() - 20)), Contains("cut.ply: "));
  CHECK_THAT(refusal("cut.stl", binary_stl().substr(0, 134)),
             Contains("cut.stl: its size is not that of its 4 triangles"));
  CHECK_THAT(refusal("nan.obj", with(obj, "v 2 0 0", "v nan 0 0")), Contains("line 2 is not a point"));
  CHECK_THAT(refusal("short.obj", with(obj, "v 2 0 0", "v 2 0")), Contains("line 2 is not a point"));
  CHECK_THAT(refusal("mark.obj", "\xEF\xBB\xBF" + obj), Contains("line 1 begins with a byte order mark"));
  for (const char* const face : {"f 2 3 9", "f 2 3 0", "f 2 3 -9"})
    CHECK_THAT(refusal("face.obj", with(obj, "f 2 3 4", face)),
               Contains("line 8 has a point that is not there"));
  CHECK_THAT(refusal("face.ply", with(ply, "3 1 2 3", "3 1 2 9")),
             Contains("a face has a point that is not there"));
  CHECK_THAT(refusal("face.vtp", with(vtp, "3 2 1 2 3<", "3 2 1 2 9<")),
             Contains("a face has a point that is not there"));
}

// Where the surface is built, which names the point.
TEST_CASE("numbers of a mesh that are not finite are read as they are", "[snapshot]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "nan.stl", std::ios::binary)
      << binary_stl(std::numeric_limits<float>::quiet_NaN());
  const std::vector<double> numbers = backend().read_mesh(directory / "nan.stl");
  REQUIRE(numbers.size() == 1 + 3 * 4 + 3 * 4);
  CHECK(std::count_if(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); }) == 1);
}
