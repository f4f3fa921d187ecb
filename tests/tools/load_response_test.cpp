#include "program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace scree::test;

namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows_of_table(const std::string& table) {
  std::vector<Row> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

// Value of a column at the end of a stage.
double last_of(const std::vector<Row>& series, std::size_t column, int stage) {
  double last = 0;
  for (std::size_t r = 1; r < series.size(); ++r)
    if (std::atoi(series[r].back().c_str()) == stage) last = std::atof(series[r][column].c_str());
  return last;
}

std::size_t column_of(const std::vector<Row>& series, const std::string& name) {
  std::size_t k = 0;
  while (series[0].at(k).find(name) == std::string::npos) ++k;
  return k;
}

// Change of a column from the end of one stage to the end of the next.
double change(const std::vector<Row>& series, const std::string& column, int stage) {
  const std::size_t k = column_of(series, column);
  return last_of(series, k, stage + 1) - last_of(series, k, stage);
}

double number(const std::vector<Row>& table, const std::vector<std::string>& first, std::size_t column) {
  for (const Row& row : table)
    if (std::equal(first.begin(), first.end(), row.begin())) return std::atof(row.at(column).c_str());
  FAIL("no such row: " << first.back());
  return 0;
}

constexpr double load = 1e-5;  // (Pa), a thousandth of a percent of the stress on the walls

// 16 discs with painted points and without slip, at rest with drag, then under a load.
std::string scenario(bool loaded) {
  std::string text = text_of(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml");
  text =
      with(text.substr(0, text.find("[[stage]]\nname = \"cycles\"")), "disc_cundall_strack", "disc_angular");
  text += "[[stage]]\nname = \"hold\"\nduration = 200\nset.discs.friction = 1e9\n";
  if (loaded) text += "[[stage]]\nname = \"load\"\nduration = 200\nset.box.stress_y_high = 1.00001\n";
  return text +
         "[[probe]]\nplugin = \"box\"\nevery = 1\n"
         "[[probe]]\nplugin = \"walls\"\nwalls = [2, 4]\nevery = 1\n"
         "[[probe]]\nplugin = \"contact\"\npairs = [1, 2, 2, 6, 3, 4]\nevery = 1\n";
}

}  // namespace

// What the forces on the walls lack of their pressure after the stages, as a share of the load, may be
// missing in every change, before and after it; the response bends by 1e-4.
TEST_CASE("the straight paths of a linear response are those of a packing under a small load", "[tools]") {
  Workspace w(scenario(false));
  const Outcome response = w.scree("modes scene.toml --loads --modes 1 --set time.step=1.4e-3 --out out");
  INFO(response.err);
  REQUIRE(response.status == 0);
  Workspace under_load(scenario(true));
  REQUIRE(under_load.scree("run scene.toml --quiet --set time.step=1.4e-3 --out out").status == 0);
  const auto box = rows_of_table(under_load.text("out/series/box.csv")),
             contact = rows_of_table(under_load.text("out/series/contact.csv"));
  // Force of the contacts on the upper and the right wall, less the pressure of 1 Pa on it. Side walls bear a
  // part of what the others lack.
  const auto pressed = rows_of_table(under_load.text("out/series/walls.csv"));
  const double missing =
      std::max(std::abs(last_of(pressed, column_of(pressed, "normal_force_2"), 2) - last_of(box, 2, 2)),
               std::abs(last_of(pressed, column_of(pressed, "normal_force_4"), 2) - last_of(box, 1, 2)));
  CAPTURE(missing);
  REQUIRE(missing < 0.01 * load);
  const double tolerance = 2 * missing / load + 1e-4;
  const double force = load * std::atof(box.back().at(1).c_str());  // on the upper wall, as long as the box

  const auto walls = rows_of_table(w.text("out/loads.csv"));
  for (const auto& [wall, column] :
       std::map<std::string, std::string>{{"box.x_high", "length_x"}, {"box.y_high", "length_y"}}) {
    CAPTURE(wall);
    // Walls move inwards.
    const double expected = -force * number(walls, {"box.y_high", wall}, 2);
    CHECK(change(box, column, 2) == Approx(expected).epsilon(tolerance));
  }
  const auto contacts = rows_of_table(w.text("out/load_contacts.csv"));
  for (const auto& [a, b] :
       std::vector<std::pair<std::string, std::string>>{{"1", "2"}, {"2", "6"}, {"3", "4"}}) {
    CAPTURE(a, b);
    const std::vector<std::string> row = {"box.y_high", a, b};
    CHECK(change(contact, "normal_force_" + a + "_" + b, 2) ==
          Approx(force * number(contacts, row, 6)).epsilon(tolerance));
    CHECK(change(contact, "tangential_force_" + a + "_" + b, 2) ==
          Approx(force * number(contacts, row, 7)).epsilon(tolerance));
  }
  CHECK(rows_of_table(w.text("out/load_bodies.csv")).size() == 1 + 2 * 16);
}

TEST_CASE("a packing without walls that forces move has no response to loads", "[tools]") {
  const Workspace w(text_of(SCREE_TEST_SOURCE "/scenarios/sound/chain.toml"));
  const Outcome outcome = w.scree("modes scene.toml --loads --fewest-contacts 1 --modes 1 --out out");
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(
      outcome.err ==
      "scree: scene.toml: no wall is moved by forces, on which a load could grow; give a wall a stress or a force, or leave "
      "--loads out\n");
  CHECK_FALSE(w.has("out"));
}
