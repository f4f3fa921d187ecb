#include <catch2/catch.hpp>

#include <scree/packing/contact_table.hpp>

using namespace scree;
using namespace scree::packing;

namespace {

ContactTable three_contacts() {
  ContactTable table;
  table.time = 0.25;
  table.walls = {"box.z_low", "a,b"};
  table.contacts = {
      {.a = 9,
       .b = 7,
       .normal = {{0, -0.6, 0.8}},
       .force = {{1, -2, 3}},
       .overlap = 1e-6,
       .point = {{4, 5, 6}}},
      {.a = 7,
       .wall = 1,
       .normal = {{1, 0, 0}},
       .force = {{0.5, 0, 0}},
       .overlap = 0.125,
       .point = {{1, 2, 3}}},
      {.a = 7, .wall = 0, .normal = {{0, 0, 1}}, .force = {{0, 0, 2}}, .overlap = 0.5, .sliding = true}};
  return table;
}

}  // namespace

TEST_CASE("the table of contacts has the smaller id first, and the name of the wall in place of the other") {
  CHECK(format_contacts_csv(three_contacts()) ==
        "# dimension: 3\n# time [s]: 0.25\n"
        "a,b,wall,normal_x,normal_y,normal_z,force_x [N],force_y [N],force_z [N],overlap [m],sliding,"
        "x [m],y [m],z [m]\n"
        "7,9,,0,0.6,-0.8,-1,2,-3,1e-06,0,4,5,6\n"
        "7,,box.z_low,0,0,1,0,0,2,0.5,1,0,0,0\n"
        "7,,wall 2,1,0,0,0.5,0,0,0.125,0,1,2,3\n");
}

TEST_CASE("the table of contacts in 2D has no z, and says if its forces were evaluated") {
  ContactTable table = three_contacts();
  table.dimension = 2;
  table.contacts.resize(1);
  table.evaluated = true;
  CHECK(format_contacts_csv(table) ==
        "# dimension: 2\n# time [s]: 0.25\n"
        "# forces: evaluated from positions, velocities and springs, since the state has none\n"
        "a,b,wall,normal_x,normal_y,force_x [N],force_y [N],overlap [m],sliding,x [m],y [m]\n"
        "7,9,,0,0.6,-1,2,1e-06,0,4,5\n");
}
