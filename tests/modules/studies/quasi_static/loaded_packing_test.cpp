#include "loaded_packing.hpp"

#include "prepared.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/response/rest.hpp>
#include <scree/wall_surfaces.hpp>

// Packings in balance with their load, checked by the kernel, which shares no code with the search for
// balance but the contact laws.

namespace scree::test {

namespace {

using quasi_static::LoadedPacking;
using quasi_static::Sample;

// A contact law between glass beads.
std::string beads_with(const std::string& law) {
  return "[[contact]]\nname = \"beads\"\nplugin = \"" + law +
         "\"\nnormal_stiffness = 1e4\nrestitution = 0.3\ntangential_stiffness = 5e3\nstatic_friction = 0.3\n";
}

double largest_load(const Simulation& s) {
  double largest = 0;
  for (const scree_load& load : s.loads())
    for (const double f : load.force) largest = std::max(largest, std::abs(f));
  for (const scree_frame_load& load : s.surfaces().loads)
    for (const double f : load.force) largest = std::max(largest, std::abs(f));
  return largest;
}

// After one step from rest, twice the momentum over the step: the force that was not in balance at its end
// (N); likewise torques over the radius.
double unbalanced(const Simulation& s) {
  const Particles& p = s.particles();
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int k = 0; k < p.dimension(); ++k)
      largest = std::max(largest, std::abs(2 * p.mass[i] * p.velocity()[k][i] / s.step_length()));
    for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
      largest =
          std::max(largest, std::abs(2 * p.inertia[i] * p.spin()[k][i] / s.step_length() / p.radius()[i]));
  }
  return largest;
}

// Largest difference between the force of the contacts on a wall that loads move and its load where it is
// (N).
double unbalanced_walls(const Simulation& s, const Sample& sample) {
  const WallEquations equations = s.linear_walls(sample.time, sample.planes, sample.frames);
  double largest = 0;
  for (std::size_t w = 0; w < equations.walls.size(); ++w) {
    const scree_linear_wall& wall = equations.walls[w];
    double force = wall.pressing_force;
    const bool plane = w < sample.planes.size();
    const double* const load =
        plane ? sample.loads[w].force : sample.surface_loads[w - sample.planes.size()].force;
    for (int k = 0; k < 3; ++k) force += wall.direction[k] * load[k];
    if (wall.free) largest = std::max(largest, std::abs(force));
  }
  return largest;
}

// The samples of a packing after these shares of a period (s), each checked. `load`: what it did.
std::vector<Sample> balanced(Prepared prepared, double period, const std::vector<double>& shares,
                             quasi_static::FollowedLoad& load) {
  const double start = prepared.simulation->time();
  const std::unique_ptr<Simulation> at_start = prepared.from(prepared.simulation->state());
  load.increment = period / 40;
  LoadedPacking packing(
      prepared.plan, 1, [] { return true; }, load);
  REQUIRE(packing.begin(std::move(prepared.simulation)));
  std::vector<Sample> samples;
  for (const double share : shares) {
    const auto sample = packing.advance(start + share * period);
    REQUIRE(sample);
    REQUIRE_FALSE(packing.moves());
    CHECK(sample->time == Approx(start + share * period));
    const auto moving = prepared.from(packing.state());
    // As below, over the mean force, torques of contacts included.
    CHECK(response::rest_of(*moving, {.fewest_contacts = 1}).unbalance < 1e-9);
    moving->step();
    INFO("after " << share << " of the period");
    // The tolerance of the search, 1e-11 of the largest force on a contact or a wall, which is at most some
    // loads; the round-off of overlaps, 1e-16 R of 1e-3 R, is less.
    CHECK(1e10 * unbalanced(*moving) < largest_load(*moving));
    CHECK(1e10 * unbalanced_walls(*at_start, *sample) < largest_load(*moving));
    samples.push_back(*sample);
  }
  packing.end_search();
  return samples;
}

}  // namespace

TEST_CASE("a packing that follows a load is at rest for the kernel: discs") {
  for (const std::string law : {"disc_cundall_strack", "disc_corrected", "disc_angular"}) {
    INFO(law);
    quasi_static::FollowedLoad load;
    const auto samples = balanced(Prepared(box_of_discs, {"scene.seed=5", "contact.discs.plugin=" + law}), 10,
                                  {0, 0.3, 0.4, 0.7, 1}, load);
    CHECK(samples[2].sliding > 0);
    CHECK(load.increments >= 40);
    CHECK(load.iterations >= load.increments);
    CHECK(load.hand_overs.empty());
  }
}

TEST_CASE("a packing that follows a load is at rest for the kernel: spheres") {
  const std::string text = text_of(box_of_spheres);
  const std::size_t contact = text.find("[[contact]]"), boundary = text.find("[[boundary]]");
  // With this seed the packing is at rest within 10 s with each law; others creep for up to 200 s.
  const std::vector<std::string> small = {"particles.lattice.count=[2,2,3]",
                                          "time.step=1e-4",
                                          "time.step_guard=false",
                                          "scene.seed=3",
                                          "stage.prepare.until.kinetic_over_elastic=1e-13",
                                          "stage.prepare.until.at_most=100"};
  for (const std::string law :
       {"plugin = \"linear_spring_dashpot\"\nnormal_stiffness = 5000\nnormal_damping = 0.05\n"
        "tangential_stiffness = 1000\ntangential_damping = 0.01\nstatic_friction = 0.1\n",
        "plugin = \"sphere_path_independent\"\nnormal_stiffness = 5000\nnormal_damping = 0.05\n"
        "tangential_stiffness = 1000\ntangential_damping = 0.01\nstatic_friction = 0.1\n",
        "plugin = \"hertz_mindlin\"\nyoungs_modulus = 1e7\npoissons_ratio = 0.25\nrestitution = 0.8\n"
        "friction = 0.2\nhistory = \"potential\"\n"}) {
    INFO(law);
    const std::string with_law =
        text.substr(0, contact) + "[[contact]]\nname = \"grains\"\n" + law + "\n" + text.substr(boundary);
    quasi_static::FollowedLoad load;
    balanced(Prepared(plan_of(with_law, small)), 1, {0, 0.25, 0.5}, load);
  }
}

// Beads in a cylinder, under a disc that a force presses. With this seed they are at rest within 5 s with
// both laws; in others some beads roll on.
TEST_CASE("a packing that follows a load is at rest for the kernel: spheres in a cylinder under a lid") {
  const std::string text =
      "[scene]\nseed = 2\n[time]\nstep = 2e-5\nstep_guard = false\n"
      "[[particles]]\nname = \"beads\"\nmaterial = \"glass\"\n"
      "random = { solid_fraction = 0.25 }\nradius = { distribution = \"uniform\", minimum = 2.3e-3, maximum = 2.7e-3 }\n"
      "region = { kind = \"cylinder\", centre = [0, 0, 0.018], radius = 9.5e-3, length = 0.034 }\n"
      "[[material]]\nname = \"glass\"\ndensity = 2500\n"
      "[[boundary]]\nplugin = \"cylinder\"\nname = \"mantle\"\npoint = [0, 0, 0]\naxis = [0, 0, 1]\nradius = 1e-2\n"
      "[[boundary]]\nplugin = \"disc\"\nname = \"floor\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 1e-2\n"
      "[[boundary]]\nplugin = \"disc\"\nname = \"lid\"\npoint = [0, 0, 0.037]\nnormal = [0, 0, -1]\nradius = 1e-2\n"
      "force = 0.5\nmass = 0.05\nviscosity = 2\n"
      "[[body_force]]\nplugin = \"background_damping\"\ntranslational = 0.02\nrotational = 0.02\n"
      "[[stage]]\nname = \"press\"\nuntil = { kinetic_over_elastic = 1e-14, at_least = 0.1, at_most = 5 }\n"
      "[[stage]]\nname = \"load\"\nduration = 1\nset.lid.force = { from = 0.5, to = 0.7, duration = 1 }\n";
  for (const std::string law : {"linear_spring_dashpot", "sphere_path_independent"}) {
    INFO(law);
    quasi_static::FollowedLoad load;
    const auto samples = balanced(Prepared(plan_of(text + beads_with(law))), 1, {0, 0.5, 1}, load);
    CHECK(samples[2].frames[2].position[2] < samples[0].frames[2].position[2]);
    CHECK(samples[2].surface_loads[2].force[2] == Approx(0.7));
  }
}

#if SCREE_TEST_PICTURES  // whose library reads meshes
// Four beads in a box, which a lid presses and drags, between planes and inside a mesh of 1200 triangles.
// The balance is found to 1e-11 of forces of 1 N, which is 1e-15 m; springs keep the round-off of places, up
// to 5e-19 m in each of at most 250 000 steps of preparation.
TEST_CASE("a quasi-static load moves beads in a box of triangles as in one of planes") {
  const std::string text =
      "particle = [\n"
      "{ position = [-4.5e-3, -4.5e-3, -4.49e-3], radius = 4.52e-3, material = \"glass\" },\n"
      "{ position = [4.5e-3, -4.5e-3, -4.48e-3], radius = 4.53e-3, material = \"glass\" },\n"
      "{ position = [-4.5e-3, 4.5e-3, -4.48e-3], radius = 4.53e-3, material = \"glass\" },\n"
      "{ position = [4.5e-3, 4.5e-3, -4.47e-3], radius = 4.54e-3, material = \"glass\" }]\n"
      "[time]\nstep = 2e-5\n[[material]]\nname = \"glass\"\ndensity = 2500\n"
      "[[boundary]]\nplugin = \"plane\"\nname = \"lid\"\npoint = [0, 0, 1e-4]\nnormal = [0, 0, -1]\n"
      "direction = [0.5, 0.2, -1]\nforce = 1\ncontrol = \"force\"\nmass = 0.05\nviscosity = 5\n"
      "[[body_force]]\nplugin = \"background_damping\"\ntranslational = 0.1\nrotational = 0.1\n"
      "[[stage]]\nname = \"press\"\nuntil = { kinetic_over_elastic = 1e-18, at_least = 0.1, at_most = 5 }\n"
      "[[stage]]\nname = \"load\"\nduration = 1\nset.lid.force = { from = 1, to = 2, duration = 1 }\n";
  const std::string planes =
      "[[boundary]]\nplugin = \"box\"\nlower = [-9e-3, -9e-3, -9e-3]\nupper = [9e-3, 9e-3, 9e-3]\nx = \"fixed\"\n"
      "y = \"fixed\"\nz = \"fixed\"\n";
  const std::string mesh = "[[boundary]]\nplugin = \"mesh\"\nname = \"box\"\nfile = \"" SCREE_TEST_SOURCE
                           "/scenarios/surfaces/cube.stl\"\nscale = 0.36e-3\nside = \"inside\"\n";
  for (const std::string law : {"linear_spring_dashpot", "sphere_path_independent"}) {
    INFO(law);
    const auto places = [&](const std::string& walls) {
      quasi_static::FollowedLoad load;
      Prepared prepared(plan_of(text + beads_with(law) + walls));
      const std::unique_ptr<Simulation> start = prepared.from(prepared.simulation->state());
      load.increment = 1.0 / 40;
      LoadedPacking packing(
          prepared.plan, 1, [] { return true; }, load);
      const double time = prepared.simulation->time();
      REQUIRE(packing.begin(std::move(prepared.simulation)));
      REQUIRE(packing.advance(time + 1));
      CHECK(load.hand_overs.empty());
      const std::unique_ptr<Simulation> end = prepared.from(packing.state());
      std::vector<Vec3> all;
      for (std::size_t i = 0; i < 4; ++i) {
        all.push_back(end->particles().body(i).position);
        all.push_back(all.back() - start->particles().body(i).position);
      }
      // What goes on from there is at rest.
      end->step();
      CHECK(1e10 * unbalanced(*end) < largest_load(*end));
      return all;
    };
    const std::vector<Vec3> between = places(planes), inside = places(mesh);
    for (std::size_t k = 0; k < between.size(); k += 2) {
      CHECK(norm(inside[k] - between[k]) < 1.3e-13);
      CHECK(norm(between[k + 1]) > 1e-6);
    }
  }
}
#endif

// Some beads cross the period, and their contacts join images.
TEST_CASE(
    "a packing that follows a load is at rest for the kernel: spheres between walls, periodic otherwise") {
  const std::string text = text_of(box_of_spheres);
  const std::size_t particles = text.find("[particles]"), material = text.find("[[material]]"),
                    box = text.find("[[boundary]]"), forces = text.find("[[body_force]]"),
                    cycles = text.find("[[stage]]\nname = \"cycles\"");
  const std::string plan =
      text.substr(0, particles) +
      "[particles]\nlattice = { kind = \"simple_cubic\", count = [3, 3, 3], spacing = 1.1e-2, displacement = 2e-4, "
      "origin = [0, 0, 0] }\nradius = { distribution = \"uniform\", minimum = 4.4e-3, maximum = 5e-3 }\n"
      "material = \"grain\"\n\n" +
      text.substr(material, box - material) +
      "[[boundary]]\nplugin = \"periodic\"\naxes = \"xz\"\nlower = [0, 0, 0]\nupper = [3.3e-2, 1, 3.3e-2]\n\n"
      "[[boundary]]\nplugin = \"plane\"\nname = \"bottom\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n\n"
      "[[boundary]]\nplugin = \"plane\"\nname = \"top\"\npoint = [0, 3.5e-2, 0]\nnormal = [0, -1, 0]\n"
      "direction = [0, -1, 0]\ncontrol = \"stress\"\nstress = 1000\narea = 1.089e-3\nmass = 0.01\nviscosity = 2\n\n" +
      text.substr(forces, cycles - forces) +
      "[[stage]]\nname = \"cycle\"\nduration = 1\n"
      "set.top.stress = { from = 1000, to = 1100, period = 1 }\n";
  Prepared prepared(
      plan_of(plan, {"time.step=1e-4", "time.step_guard=false",
                     "stage.prepare.until.kinetic_over_elastic=1e-13", "stage.prepare.until.at_most=100"}));
  CHECK(std::any_of(prepared.simulation->particles().image[0].begin(),
                    prepared.simulation->particles().image[0].end(), [](int image) { return image != 0; }));
  quasi_static::FollowedLoad load;
  balanced(std::move(prepared), 1, {0, 0.25, 0.5}, load);
}

}  // namespace scree::test
