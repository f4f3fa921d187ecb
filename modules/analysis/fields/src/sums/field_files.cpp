#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include <scree/fields/field_files.hpp>

namespace scree::fields {

namespace {

// A field as both kinds of files have it.
struct FieldColumn {
  const char* name;
  const char* unit;  // in 2D of discs of 1 m depth
  int rank;          // 0: number, 1: vector, 2: tensor
  // Component of number, vector or tensor.
  double (*value)(const FieldPoint&, std::size_t);
};

constexpr FieldColumn field_columns[] = {
    {"density", "kg/m^3", 0, [](const FieldPoint& p, std::size_t) { return p.density; }},
    {"solid_fraction", "", 0, [](const FieldPoint& p, std::size_t) { return p.solid_fraction; }},
    {"momentum", "kg/(m^2 s)", 1, [](const FieldPoint& p, std::size_t c) { return p.momentum[int(c)]; }},
    {"velocity", "m/s", 1, [](const FieldPoint& p, std::size_t c) { return p.velocity[int(c)]; }},
    {"contact_stress", "Pa", 2, [](const FieldPoint& p, std::size_t c) { return p.contact_stress[c]; }},
    {"kinetic_stress", "Pa", 2, [](const FieldPoint& p, std::size_t c) { return p.kinetic_stress[c]; }},
    {"traction", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.traction[int(c)]; }},
    {"body_force", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.body_force[int(c)]; }},
    {"group_load", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.group_load[int(c)]; }},
    {"holding_force", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.holding_force[int(c)]; }},
    {"net_force", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.net_force[int(c)]; }},
    {"residual", "N/m^3", 1, [](const FieldPoint& p, std::size_t c) { return p.residual()[int(c)]; }},
};

// The components that a scene has, as "xy", and which number each has in three dimensions.
template <class Use>
void each_component(int rank, int dimension, const Use& use) {
  static constexpr std::string_view axes = "xyz";
  const auto n = std::size_t(dimension);
  if (rank == 0) use("", std::size_t(0));
  for (std::size_t i = 0; rank == 1 && i < n; ++i) use(fmt::format("_{}", axes[i]), i);
  for (std::size_t i = 0; rank == 2 && i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) use(fmt::format("_{}{}", axes[i], axes[j]), 3 * i + j);
}

// What the columns of a row are, each with its component.
struct RowCell {
  const FieldColumn* column;
  std::size_t component;
};

std::vector<RowCell> cells_of_row(int dimension) {
  std::vector<RowCell> cells;
  for (const FieldColumn& column : field_columns)
    each_component(column.rank, dimension, [&](const std::string&, std::size_t c) {
      cells.push_back({&column, c});
    });
  return cells;
}

std::string vtk_triple(const Vec3& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

void write_array(std::string& out, const FieldColumn& column, const std::vector<FieldPoint>& points) {
  const int components = column.rank == 0 ? 1 : column.rank == 1 ? 3 : 9;
  const auto end = std::back_inserter(out);
  fmt::format_to(
      end, "        <DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
      column.name, components);
  for (const FieldPoint& point : points)
    for (int c = 0; c < components; ++c)
      fmt::format_to(end, "{}{}", column.value(point, std::size_t(c)), c + 1 == components ? '\n' : ' ');
  out += "        </DataArray>\n";
}

}  // namespace

std::string format_csv_header(int dimension) {
  std::string line = "time [s]";
  each_component(1, dimension,
                 [&](const std::string& axis, std::size_t) { line += "," + axis.substr(1) + " [m]"; });
  for (const FieldColumn& column : field_columns) {
    const std::string_view unit = column.unit;
    each_component(column.rank, dimension, [&](const std::string& axes, std::size_t) {
      line += fmt::format(",{}{}", column.name, axes);
      if (!unit.empty()) line += fmt::format(" [{}]", unit);
    });
  }
  return line + '\n';
}

std::string format_csv_rows(const FieldGrid& grid, const FieldFrame& frame) {
  std::string out;
  const auto end = std::back_inserter(out);
  const std::vector<RowCell> cells = cells_of_row(grid.dimension);
  for (std::size_t number = 0; number < frame.points.size(); ++number) {
    const Vec3 x = grid.point(number);
    fmt::format_to(end, "{}", frame.time);
    for (int k = 0; k < grid.dimension; ++k) fmt::format_to(end, ",{}", x[k]);
    for (const RowCell& cell : cells)
      fmt::format_to(end, ",{}", cell.column->value(frame.points[number], cell.component));
    out += '\n';
  }
  return out;
}

std::string format_csv(const FieldGrid& grid, const std::vector<FieldFrame>& frames,
                       const std::vector<std::string>& comments) {
  std::string out;
  for (const std::string& comment : comments) out += "# " + comment + '\n';
  out += format_csv_header(grid.dimension);
  for (const FieldFrame& frame : frames) out += format_csv_rows(grid, frame);
  return out;
}

std::string format_vti(const FieldGrid& grid, const FieldFrame& frame) {
  const std::string extent =
      fmt::format("0 {} 0 {} 0 {}", grid.count[0] - 1, grid.count[1] - 1, grid.count[2] - 1);
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <ImageData WholeExtent=\"{0}\" Origin=\"{1}\" Spacing=\"{2}\">\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n{3}\n"
      "      </DataArray>\n"
      "    </FieldData>\n"
      "    <Piece Extent=\"{0}\">\n"
      "      <PointData Scalars=\"density\">\n",
      extent, vtk_triple(grid.first), vtk_triple(grid.spacing), frame.time);
  for (const FieldColumn& column : field_columns) write_array(out, column, frame.points);
  return out + "      </PointData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n";
}

std::string format_pvd(const std::vector<TimedFile>& files) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const TimedFile& file : files)
    out += fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", file.time, file.file);
  return out + "  </Collection>\n</VTKFile>\n";
}

}  // namespace scree::fields
