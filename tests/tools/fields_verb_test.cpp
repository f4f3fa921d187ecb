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

TEST_CASE("a run writes the fields that the verb computes of its states", "[tools]") {
  const Workspace w(
      pressed_stages +
      "[[fields]]\nevery = 5e-5\nformat = 'csv'\nname = 'table'\nspacing = 0.005\nkernel = 'lucy'\n"
      "[[fields]]\nevery = 1e-4\nstages = ['second']\nplane = { y = 0.02 }\nwidth = 0.03\n");
  const Outcome run = w.run();
  INFO(run.err);
  REQUIRE(run.status == 0);
  const std::vector<double> time = column(w.text("out/fields/table.csv"), "time");
  REQUIRE(time.size() % 5 == 0);
  const std::size_t points = time.size() / 5;
  CHECK(time[0] == 0);
  CHECK(time[points] == Approx(5e-5));
  CHECK(time.back() == Approx(2e-4));
  // The grid of the run is that of its first step, from the bodies there.
  const std::string lower = "-0.01,-0.0001", upper = "0.0298,0.037";
  for (const auto& [state, frame] : {std::pair{"states/first.h5", 2}, std::pair{"final_state.h5", 4}}) {
    CAPTURE(state);
    REQUIRE(w.scree(std::string("fields out/") + state +
                    " --kernel lucy --spacing 0.005 --width 0.04 --lower " + lower + " --upper " + upper +
                    " --overwrite --out state.csv")
                .status == 0);
    for (const char* name :
         {"x [m]", "density", "velocity_x", "contact_stress_xy", "kinetic_stress_yy", "traction_y"}) {
      CAPTURE(name);
      const std::vector<double> of_run = column(w.text("out/fields/table.csv"), name),
                                of_state = column(w.text("state.csv"), name);
      REQUIRE(of_state.size() == points);
      for (std::size_t k = 0; k < points; ++k)  // places of the grid differ by round-off
        CHECK(of_run[std::size_t(frame) * points + k] == Approx(of_state[k]).epsilon(1e-11).margin(1e-11));
    }
  }
  CHECK_FALSE(w.has("out/fields/fields_0000000000.vti"));
  CHECK_THAT(w.text("out/fields/fields.pvd"), Catch::Contains("file=\"fields_0000000010.vti\"") &&
                                                  Catch::Contains("file=\"fields_0000000020.vti\""));
  CHECK_THAT(w.text("out/fields/fields_0000000020.vti"), Catch::Contains("WholeExtent=\"0 2 0 0 0 0\""));

  REQUIRE(w.shell("cp -r out/fields first && scree resume out --from first --overwrite").status == 0);
  CHECK(w.shell("diff -r out/fields first").out.empty());
  // A run that nobody asks for fields has the same motion.
  REQUIRE(w.scree("run scene.toml --set 'fields=[]' --out without").status == 0);
  CHECK(w.record("without")["state_hash"] == w.record("out")["state_hash"]);
  CHECK_FALSE(w.has("without/fields"));
}

TEST_CASE("fields of a run that are not possible are refused before anything is written", "[tools]") {
  const Workspace w(pressed_stages + "[[fields]]\nevery = 1e-4\n");
  const auto refused = [&](const std::string& set) {
    const Outcome outcome = w.run("--set " + set);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_FALSE(w.has("out"));
    return outcome.err;
  };
  CHECK_THAT(refused("fields.spacing=1e-9"),
             Catch::StartsWith("scree: scene.toml:") && Catch::Contains("spacing: gives"));
  CHECK_THAT(refused("fields.upper=[-1,-1]"), Catch::Contains("upper: is not above the lower end along x"));
  CHECK_THAT(refused("'fields.plane={ z = 1 }'"), Catch::Contains("unknown key 'z' in [fields.plane]"));
  CHECK_THAT(refused("'fields.plane={ x = 1, y = 1 }'"),
             Catch::Contains("a plane is at one place on one axis; give one axis"));
  CHECK_THAT(refused("'fields.plane={}'"),
             Catch::Contains("the plane has no axis; give for example plane = { y = 0.01 }"));
  CHECK_THAT(refused("'fields.stages=[\"third\"]'"), Catch::Contains("third"));
  CHECK_THAT(refused("fields.every=1e-9"), Catch::Contains("is shorter than the time step"));
  CHECK_THAT(refused("fields.name=a/b"), Catch::Contains("cannot be used as a file name"));
}

#if SCREE_TEST_PICTURES
TEST_CASE("fields of frames are those of the state at the same time", "[tools]") {
  const Workspace w(pressed_stages + "[snapshot]\nevery = 1e-4\n");
  REQUIRE(w.run().status == 0);
  const std::string grid =
      " --spacing 0.005 --width 0.04 --lower -0.01,-0.0001 --upper 0.0298,0.037 --overwrite --out ";
  const Outcome frames = w.scree("fields out/snapshots" + grid + "frames.csv");
  INFO(frames.err);
  REQUIRE(frames.status == 0);
  CHECK_THAT(frames.out, Catch::Contains("3 frames"));
  CHECK(printed(frames.out, "forces, ") < 1e-13);
  REQUIRE(w.scree("fields out/final_state.h5" + grid + "state.csv").status == 0);
  for (const char* name :
       {"x [m]", "density", "velocity_x", "contact_stress_xy", "kinetic_stress_yy", "body_force_y"}) {
    CAPTURE(name);
    const std::vector<double> a = column(w.text("frames.csv"), name), b = column(w.text("state.csv"), name);
    REQUIRE(a.size() == 3 * b.size());
    for (std::size_t k = 0; k < b.size(); ++k)
      CHECK(a[2 * b.size() + k] == Approx(b[k]).epsilon(1e-12).margin(1e-11));
  }
  REQUIRE(w.shell("cp out/snapshots/*_0000000020.vtp .").status == 0);
  CHECK(
      w.scree("fields particles_0000000020.vtp --out f.csv").err ==
      "scree: particles_0000000020.vtp: has no masses, and its run has no state from which to take them; give a "
      "--state of the run, or the --density of all bodies\n");
  REQUIRE(w.scree("fields particles_0000000020.vtp --density 1000" + grid + "f.csv").status == 0);
  const std::vector<double> given = column(w.text("f.csv"), "density"),
                            of_state = column(w.text("state.csv"), "density");
  for (std::size_t k = 0; k < given.size(); ++k) CHECK(given[k] == Approx(of_state[k]).epsilon(1e-12));
  std::filesystem::remove(w / "contacts_0000000020.vtp");
  CHECK_THAT(w.scree("fields particles_0000000020.vtp --density 1000 --out g.csv").err,
             Catch::StartsWith(
                 "scree: particles_0000000020.vtp: has no contacts, of which the stress is made; put"));
}
#endif

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
  CHECK_THAT(refused("--out missing/f.csv"), Catch::Contains("missing/f.csv: there is no folder ") &&
                                                 Catch::Contains("; create it, or give another --out\n"));
  CHECK(refused("--density 2500") ==
        "scree: --density: is for frames (.vtp), but out/final_state.h5 has masses; leave it out\n");
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
