#include "field_scenes.hpp"
#include "scene_text.hpp"

#include <catch2/catch.hpp>

#include <scree/fields/field_files.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

// Fields of two bodies, pressed together, at six points.
struct SmallFields {
  FieldGrid grid;
  FieldFrame frame;
};

SmallFields small_fields(int dimension) {
  FieldInput input;
  input.dimension = dimension;
  input.bodies = {{.id = 1,
                   .mass = 2,
                   .radius = 1,
                   .position = {{0, 0, 0}},
                   .velocity = {{1, 2, 0}},
                   .force = {{-3, 0.1, 0}}},
                  {.id = 2,
                   .mass = 3,
                   .radius = 1,
                   .position = {{1.9, 0, 0}},
                   .velocity = {{-1, 1, 0}},
                   .force = {{3, -0.1, 0}}}};
  input.contacts = {{.a = 1, .b = 0, .line = {{1.9, 0, 0}}, .force = {{3, -0.1, 0}}}};
  SmallFields fields;
  fields.grid.dimension = dimension;
  fields.grid.first = {{-0.5, -0.25, 0}};
  fields.grid.spacing = {{1.0 / 3, 0.5, 1}};
  fields.grid.count = {3, 2, 1};
  FieldSums sums(fields.grid, AveragingKernel(dimension, 2));
  ThreadPool one(1);
  sums.add(input, one);
  fields.frame = {0.125, sums.means()};
  return fields;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

// Value of an attribute, in the first element that has it.
std::string attribute(const std::string& xml, const std::string& name) {
  const auto begin = xml.find(" " + name + "=\"") + name.size() + 3;
  return xml.substr(begin, xml.find('"', begin) - begin);
}

// Numbers of the array of a name.
std::vector<double> array_of(const std::string& xml, const std::string& name) {
  const auto begin = xml.find('>', xml.find("Name=\"" + name + "\"")) + 1;
  std::stringstream stream(xml.substr(begin, xml.find('<', begin) - begin));
  std::vector<double> values;
  for (double value; stream >> value;) values.push_back(value);
  return values;
}

}  // namespace

TEST_CASE("a table has every field of every point and time, to the last bit", "[fields]") {
  for (const int dimension : {2, 3}) {
    SmallFields small = small_fields(dimension);
    FieldFrame later = small.frame;
    later.time = 0.25;
    const std::vector<std::string> lines =
        lines_of(format_csv(small.grid, {small.frame, later}, {"width [m]: 2"}));
    REQUIRE(lines.size() == 2 + 2 * 6);
    CHECK(lines[0] == "# width [m]: 2");
    const std::vector<std::string> names = split(lines[1], ',');
    CHECK(names[0] == "time [s]");
    const auto value = [&](std::size_t row, const std::string& name) {
      const auto at = std::find(names.begin(), names.end(), name);
      REQUIRE(at != names.end());
      const std::vector<std::string> cells = split(lines[2 + row], ',');
      REQUIRE(cells.size() == names.size());
      return std::stod(cells[std::size_t(at - names.begin())]);
    };
    const bool flat = dimension == 2;
    for (std::size_t row = 0; row < 12; ++row) {
      const FieldPoint& p = small.frame.points[row % 6];
      CHECK(value(row, "time [s]") == (row < 6 ? 0.125 : 0.25));
      CHECK(value(row, "y [m]") == small.grid.point(row % 6)[1]);
      CHECK(value(row, "density [kg/m^3]") == p.density);
      CHECK(value(row, "solid_fraction") == p.solid_fraction);
      CHECK(value(row, "velocity_y [m/s]") == p.velocity[1]);
      CHECK(value(row, "contact_stress_yx [Pa]") == p.contact_stress[3]);
      CHECK(value(row, "kinetic_stress_xy [Pa]") == p.kinetic_stress[1]);
      CHECK(value(row, "residual_x [N/m^3]") == p.residual()[0]);
    }
    CHECK((std::find(names.begin(), names.end(), "z [m]") == names.end()) == flat);
  }
}

TEST_CASE("an image of VTK has the grid and every field, to the last bit", "[fields]") {
  const SmallFields small = small_fields(3);
  const std::string xml = format_vti(small.grid, small.frame);
  CHECK(attribute(xml, "WholeExtent") == "0 2 0 1 0 0");
  CHECK(attribute(xml, "Extent") == "0 2 0 1 0 0");
  CHECK(attribute(xml, "Origin") == "-0.5 -0.25 0");
  CHECK(attribute(xml, "Spacing") == "0.3333333333333333 0.5 1");
  CHECK(array_of(xml, "TimeValue") == std::vector<double>{0.125});
  const std::vector<double> density = array_of(xml, "density"), stress = array_of(xml, "contact_stress"),
                            velocity = array_of(xml, "velocity");
  REQUIRE(density.size() == 6);
  REQUIRE(velocity.size() == 18);
  REQUIRE(stress.size() == 54);
  for (std::size_t k = 0; k < 6; ++k) {
    const FieldPoint& p = small.frame.points[k];
    CHECK(density[k] == p.density);
    CHECK(velocity[3 * k + 1] == p.velocity[1]);
    for (std::size_t c = 0; c < 9; ++c) CHECK(stress[9 * k + c] == p.contact_stress[c]);
  }
  // Every element is closed.
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::string tag = xml.substr(at + 1, xml.find('>', at) - at - 1);
    if (tag[0] == '?') continue;
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
      continue;
    }
    REQUIRE_FALSE(open.empty());
    CHECK(open.back() == tag.substr(1));
    open.pop_back();
  }
  CHECK(open.empty());
}

TEST_CASE("a collection lists files with their times", "[fields]") {
  CHECK_THAT(format_pvd({{0.5, "a_0001.vti"}, {1, "a_0002.vti"}}),
             Catch::Contains("    <DataSet timestep=\"0.5\" file=\"a_0001.vti\"/>\n"
                             "    <DataSet timestep=\"1\" file=\"a_0002.vti\"/>\n"));
}
