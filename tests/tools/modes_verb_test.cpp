#include "program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace scree::test;

TEST_CASE("modes tells the modes of a chain and writes them", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("modes scene.toml --modes 3 --density 10 --out out");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  // Across the chain its beads are held by nothing: gravity presses them, which makes them turn over.
  CHECK(outcome.err.find("scree: warning: the packing is unstable: ") == 0);
  CHECK(outcome.out.find("8 bodies with 8 contacts") != std::string::npos);
  const nlohmann::json record = w.record("out", "modes.json");
  CHECK(record["status"] == "finished");
  CHECK(record["complete"] == true);
  const double exact[] = {29.370, 87.110, 141.883};
  for (int m = 0; m < 3; ++m)
    CHECK(double(record["modes"]["mode_" + std::to_string(m + 1)]["frequency"]) ==
          Approx(exact[m]).epsilon(1e-4));
  CHECK(w.text("out/modes.csv").starts_with("kind,number,frequency [Hz],"));
  CHECK(lines_of(w.text("out/density.csv")).size() == 11);
  CHECK(w.has("out/charts/density.png"));
  CHECK(w.scree("modes scene.toml --out out").err ==
        "scree: out: already contains a table of modes; give another --out, or --overwrite to replace it\n");
  CHECK(w.scree("modes scene.toml --out out --overwrite --quiet --near 88 --modes 1").status == 0);
  CHECK(double(w.record("out", "modes.json")["modes"]["mode_1"]["frequency"]) ==
        Approx(87.110).epsilon(1e-4));
  CHECK(!w.has("out/density.csv"));
}

TEST_CASE("the page of modes has the command that finds them again", "[tools]") {
  const Workspace w(chain);
  const std::string options =
      "--modes 2 --residual 0.02 --near 88 --density 5 --density-to 150 --fewest-contacts 1";
  REQUIRE(w.scree("modes scene.toml --quiet --sliding --out out " + options).status == 0);
  const std::string page = w.text("out/report.html");
  const std::string before = "<code>scree ";
  const std::size_t begin = page.find(before + "modes scenario.toml"), end = page.find("</code>", begin);
  REQUIRE(end < page.size());
  const std::string call = page.substr(begin + before.size(), end - begin - before.size());
  CHECK(call.find("--near 88.0") != std::string::npos);
  CHECK(call.ends_with(" --sliding"));
  CHECK(page.find("with the other options") == std::string::npos);
  REQUIRE(w.shell("cd out && '" SCREE_TEST_PROGRAM "' " + call).status == 0);
  for (const char* table : {"modes.csv", "density.csv"})
    CHECK(w.text(std::string("out/again/") + table) == w.text(std::string("out/") + table));
  CHECK(w.record("out/again", "modes.json")["options"] == w.record("out", "modes.json")["options"]);
}

// On three beads: it rises with 3 k_n/m, and turns with 3 k_t r²/I.
TEST_CASE("modes finds the motions of a lid and its response to a load", "[tools]") {
  const Workspace w(
      "particle = [\n{ position = [0.7, 0, -0.29], radius = 0.3, material = \"glass\" },\n"
      "{ position = [-0.35, 0.6, -0.29], radius = 0.3, material = \"glass\" },\n"
      "{ position = [-0.35, -0.6, -0.29], radius = 0.3, material = \"glass\" }]\n"
      "[[group]]\nname = \"all\"\nwhere = { material = \"glass\" }\nfixed = true\n"
      "[time]\nstep = 1e-4\n[[material]]\nname = \"glass\"\ndensity = 2500\n"
      "[[contact]]\nplugin = \"linear_spring_dashpot\"\nnormal_stiffness = 1000\nnormal_damping = 0\n"
      "tangential_stiffness = 600\nstatic_friction = 0.5\n"
      "[[boundary]]\nplugin = \"disc\"\nname = \"lid\"\npoint = [0, 0, 0]\nnormal = [0, 0, -1]\nradius = 1\n"
      "force = 30\nmass = 5\ntorque = 0\ninertia = 2.5\n"
      "[[stage]]\nname = \"none\"\nduration = 1e-4\n");
  const Outcome outcome = w.scree("modes scene.toml --modes 2 --loads --fewest-contacts 1 --out out");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  const nlohmann::json record = w.record("out", "modes.json");
  const double r_squared = (0.49 + 2 * (0.35 * 0.35 + 0.36)) / 3;
  CHECK(double(record["modes"]["mode_1"]["frequency"]) ==
        Approx(std::sqrt(3 * 600 * r_squared / 2.5) / (2 * std::numbers::pi)).epsilon(1e-6));
  CHECK(double(record["modes"]["mode_2"]["frequency"]) ==
        Approx(std::sqrt(3 * 1000 / 5.0) / (2 * std::numbers::pi)).epsilon(1e-6));
  const std::vector<std::string> modes = lines_of(w.text("out/modes.csv"));
  REQUIRE(modes.size() == 3);
  CHECK(modes[0].find(",walls,wall_turns,") != std::string::npos);
  CHECK(w.text("out/loads.csv").find("lid,lid,") != std::string::npos);
}

#if SCREE_TEST_PICTURES
TEST_CASE("modes draws the modes that are asked for", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("modes scene.toml --modes 2 --picture 1,2 --view x --quiet --out out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(w.has("out/images/mode_1.png"));
  CHECK(w.has("out/images/mode_2.png"));
}
#endif

TEST_CASE("modes refuses what it cannot do in one line and writes nothing", "[tools]") {
  const Workspace w(chain);
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("modes " + arguments), begin, end);
    CHECK(!w.has("out"));
  };
  refused("--out out", "scenario is required", "see scree modes --help");
  refused("scene.toml --out out --elastic", "scene.toml: elastic constants need two parallel walls",
          "or prepare such a packing");
  refused("scene.toml --out out --fewest-contacts 9", "scene.toml: no body is held",
          "compress the packing, or give a fewest_contacts below 9");
  refused("scene.toml --out out --picture 1,x", "--picture 1,x: 'x' is not the number of a mode", "as 1,4,7");
  refused("scene.toml --out out --near -3", "--near:", "see scree modes --help");
}

TEST_CASE("Ctrl-C in modes saves what is complete and gives status 130", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome =
      w.shell("'" SCREE_TEST_PROGRAM
              "' modes scene.toml --modes 3 --density 100000 --quiet --out out &\nrun=$!\n"
              "(sleep 30; kill -KILL $run) > /dev/null 2>&1 &\ntrap \"kill $!\" EXIT\n"
              "until grep -q running out/modes.json 2> /dev/null; do sleep 0.01; done; sleep 0.3\n"
              "kill -TERM $run; wait $run");
  INFO(outcome.err << outcome.out);
  CHECK(outcome.status == 130);
  CHECK(outcome.out == "interrupted; what was complete is saved\nresults in out\n");
  const nlohmann::json record = w.record("out", "modes.json");
  CHECK(record["status"] == "interrupted");
  CHECK(record["modes"].size() == 3);
  CHECK(lines_of(w.text("out/modes.csv")).size() > 3);
  // What was counted before; all counts would take seconds.
  CHECK(lines_of(w.text("out/density.csv")).size() < 100001);
  CHECK(w.scree("modes scene.toml --modes 3 --quiet --out out --overwrite").status == 0);
  CHECK(w.record("out", "modes.json")["status"] == "finished");
}

TEST_CASE("modes refuses frequencies at which there is no mode to find", "[tools]") {
  const Workspace w(chain);
  const auto refused = [&](const std::string& arguments, const std::string& problem,
                           const std::string& cure) {
    const Outcome outcome = w.scree("modes scene.toml --quiet --out out " + arguments);
    check_refused(w, outcome, "scene.toml: " + problem, cure);
  };
  refused("--near 1e300", "all modes are below ", "give a lower --near");
  refused("--density 5 --density-to 1e-300", "no mode below ", "give a higher --density-to");
  refused("--density 5 --density-to 1e200", "1e+200 Hz is above 1e+100 Hz", "give a lower --density-to");
}

TEST_CASE("what a plan cannot give is refused before a step is taken", "[tools]") {
  // Twice the gravity makes the beads too fast in the first step.
  const std::string falls =
      "[[probe]]\nplugin = 'energy'\nevery = 1\n[limits]\nspeed = 1e-9\n"
      "[[stage]]\nname = 'falls'\nduration = 0.01\nset.gravity.acceleration = [0, 0, -20]\n";
  const Workspace w(with(with(chain, "[spectrum]\n", falls + "[spectrum]\n"), "ids = [1, 8]\n",
                         "ids = [1, 8]\nevery = 1\n"));
  const Outcome late = w.scree("modes scene.toml --quiet --out out");
  INFO(late.err);
  REQUIRE(late.status == 3);
  const auto refused = [&](const std::string& arguments, const std::string& problem,
                           const std::string& cure) {
    check_refused(w, w.scree(arguments + " --quiet --out out"), problem, cure);
  };
  refused("modes scene.toml --elastic", "scene.toml: elastic constants need two parallel walls",
          "or prepare such a packing");
  refused("modes scene.toml --loads", "scene.toml: no wall is moved by forces", "or leave --loads out");
  refused("modes scene.toml --density 5 --density-to 1e200", "scene.toml: 1e+200 Hz is above",
          "give a lower --density-to");
  refused("spectrum scene.toml --by linear --set \"spectrum.observe=['energy.kinetic_translation']\"",
          "--set spectrum.observe=", "or leave the method linear out");
  refused("spectrum scene.toml --by linear --set stage.falls.set.floor.control=fixed",
          "scene.toml:", "set the control that uses it");
  const std::string moved =
      "[[stage]]\nname = 'moves'\nduration = 1\nset.floor.displacement = { from = 0, to = 1e-6, duration = 1 }\n";
  w.write("scene.toml", with(w.text("scene.toml"), "[spectrum]\n", moved + "[spectrum]\n"));
  refused("quasi-static scene.toml", "scene.toml: wall floor is moved with",
          "a quasi-static load is by these");
}

// A bead that gravity presses onto a floor along an inclined direction, so that its tangential spring bears a
// load.
TEST_CASE("modes and the linear method warn of laws without a derivative at rest", "[tools]") {
  const std::string inclined =
      "[time]\nstep = 1e-6\n[[material]]\nname = 'glass'\ndensity = 2500\n"
      "[[contact]]\nplugin = 'hertz_mindlin'\nyoungs_modulus = 1e9\npoissons_ratio = 0.25\nrestitution = 0.5\n"
      "friction = 0.5\n[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
      "displacement = 0\n[[boundary]]\nplugin = 'plane'\nname = 'side'\npoint = [0.002, 0, 0]\n"
      "normal = [-1, 0, 0]\n[[body_force]]\nplugin = 'gravity'\nacceleration = [3, 0, -10]\n"
      "[[particle]]\nid = 1\nposition = [0, 0, 0.0019999]\nradius = 0.002\n[[stage]]\nduration = 2e-3\n"
      "[[probe]]\nplugin = 'particles'\nevery = 1\nids = [1]\n[spectrum]\ndrive = 'floor.displacement'\n"
      "amplitude = 1e-9\nobserve = ['particles.z_1']\nfrom_hz = 100\nto_hz = 200\nstep_hz = 50\n"
      "linear.fewest_contacts = 1\n";
  const Workspace w(inclined);
  for (const char* verb : {"modes scene.toml --modes 1", "spectrum scene.toml --by linear"}) {
    CAPTURE(verb);
    const std::string call = std::string(verb) + " --quiet --overwrite --out ";
    const Outcome rescaled = w.scree(call + verb[0]);
    INFO(rescaled.err);
    CHECK(rescaled.status == 0);
    CHECK(rescaled.err.find("have different stiffnesses in loading and unloading") != std::string::npos);
    CHECK(w.scree(call + verb[0] + " --set contact.history=\\'potential\\'").err.find("unloading") ==
          std::string::npos);
  }
}
