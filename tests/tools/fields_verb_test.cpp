#include "program.hpp"

#include <algorithm>
#include <sstream>

using namespace scree::test;

namespace {

// Three discs that are pressed into each other and a floor by 1e-4 m, saved in two stages.
const std::string pressed_stages =
    "[scene]\ndimension = 2\n[time]\nstep = 1e-5\n[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 1\n"
    "tangential_stiffness = 1e4\nstatic_friction = 0.3\n"
    "[[particle]]\nposition = [0, 0.0099]\nradius = 0.01\nvelocity = [0.1, 0]\n"
    "[[particle]]\nposition = [0.0198, 0.0099]\nradius = 0.01\n"
    "[[particle]]\nposition = [0.0099, 0.027]\nradius = 0.01\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0]\nnormal = [0, 1]\n"
    "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -9.81]\n"
    "[[stage]]\nname = 'first'\nduration = 1e-4\n[[stage]]\nname = 'second'\nduration = 1e-4\n";

// The numbers that end lines which begin so, each after ": " and before a blank or the end.
double printed(const std::string& out, const std::string& begin) {
  for (const std::string& line : lines_of(out))
    if (line.starts_with(begin)) return std::stod(line.substr(line.rfind(": ") + 2));
  return -1;
}

// A column of a table, by the beginning of its name.
std::vector<double> column(const std::string& csv, const std::string& name) {
  std::vector<double> values;
  std::size_t at = 0;
  bool header = true;
  for (const std::string& line : lines_of(csv)) {
    if (line[0] == '#') continue;
    std::stringstream cells(line);
    std::string cell;
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (header && cell.starts_with(name)) at = k;
      if (!header && k == at) values.push_back(std::stod(cell));
    }
    header = false;
  }
  return values;
}

}  // namespace

TEST_CASE("fields writes the fields of states and prints what their balances leave open", "[tools]") {
  const Workspace w(pressed_stages);
  REQUIRE(w.run().status == 0);
  const std::string states = "out/states/first.h5 out/final_state.h5";
  const Outcome both = w.scree("fields " + states + " --out both.csv --spacing 0.005");
  INFO(both.err);
  REQUIRE(both.status == 0);
  CHECK(both.out.starts_with("both.csv: 56 points, 2 states, width 0.04 m, spacing 0.00"));
  for (const char* balance : {"forces, ", "mass from ", "mass over ", "momentum over "}) {
    CAPTURE(balance);
    CHECK(printed(both.out, balance) >= 0);
    CHECK(printed(both.out, balance) < 1e-13);
  }
  const std::string csv = w.text("both.csv");
  const std::vector<double> stress = column(csv, "contact_stress_yy"), time = column(csv, "time");
  REQUIRE(stress.size() == 2 * 56);
  CHECK(*std::max_element(stress.begin(), stress.end()) > 1);
  CHECK(time.front() == Approx(1e-4));
  CHECK(time.back() == Approx(2e-4));

  REQUIRE(w.scree("fields out --out last.csv --spacing 0.005 --threads 3").status == 0);
  const std::vector<double> last = column(w.text("last.csv"), "contact_stress_yy");
  const std::vector<double> second(stress.begin() + 56, stress.end());
  CHECK(last.size() == second.size());
  CHECK(w.scree("fields " + states + " --average --out mean.csv --spacing 0.005").status == 0);
  const std::vector<double> mean = column(w.text("mean.csv"), "contact_stress_yy");
  REQUIRE(mean.size() == 56);
  CHECK(mean[20] == Approx(0.5 * (stress[20] + stress[76])));
}

TEST_CASE("fields numbers images of several states and lists them", "[tools]") {
  const Workspace w(pressed_stages);
  REQUIRE(w.run().status == 0);
  REQUIRE(w.scree("fields out/states/first.h5 out/final_state.h5 --plane y=0.02 --out f.vti").status == 0);
  CHECK(w.has("f_0001.vti"));
  CHECK_THAT(w.text("f_0002.vti"), Catch::Contains("WholeExtent=\"0 1 0 0 0 0\""));
  CHECK_THAT(w.text("f.pvd"), Catch::Contains("file=\"f_0002.vti\""));
  CHECK(w.scree("fields out/states/first.h5 out/final_state.h5 --out f.vti").err ==
        "scree: f_0001.vti: is there already; give another --out, or --overwrite\n");
}

TEST_CASE("fields refuses what it cannot compute in one line", "[tools]") {
  const Workspace w(pressed_stages);
  REQUIRE(w.run().status == 0);
  const auto refused = [&](const std::string& options) {
    const Outcome outcome = w.scree("fields out " + options);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  CHECK(refused("--out f.txt") == "scree: f.txt: is neither .csv nor .vti; give another --out\n");
  CHECK(
      refused("--plane z=1") ==
      "scree: --plane: 'z=1' is not an axis of the scene and a place on it; give for example --plane y=0.01\n");
  CHECK_THAT(refused("--lower 0,0,0"),
             Catch::Contains("--lower: has 3 numbers, but the scene has 2 axes; give"));
  CHECK_THAT(refused("--lower 0,x"),
             Catch::Contains("--lower: '0,x' is not a list of numbers with commas; give"));
  CHECK_THAT(refused("--upper -1,-1"), Catch::Contains("--upper: is not above the lower end along x"));
  CHECK_THAT(refused("--width 0"), Catch::Contains("--width"));
  CHECK_THAT(refused("--spacing 1e-9"), Catch::Contains("--spacing: gives"));
  std::filesystem::create_directory(w / "empty");
  CHECK_THAT(w.scree("fields empty").err,
             Catch::Contains("empty: has no state; give the directory of a run"));
}
