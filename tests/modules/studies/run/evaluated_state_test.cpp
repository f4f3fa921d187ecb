#include "run_support.hpp"

#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include <scree/run/evaluated_state.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Two discs on a floor, pressed into it and each other without dashpots: the force of a contact is k δ along
// its normal.
const std::string two_discs =
    "[scene]\ndimension = 2\n[time]\nstep = 1e-5\nduration = 5e-5\n"
    "[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 0\n"
    "[[particle]]\nid = 7\nposition = [0, 0.0099]\nradius = 0.01\nmass = 1\n"
    "[[particle]]\nid = 3\nposition = [0.01794, 0.03382]\nradius = 0.02\nmass = 1\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0]\nnormal = [0, 1]\n";
constexpr double disc_stiffness = 1e4;
constexpr double overlap_round_off = 1e-11;  // of an overlap of 1e-4 m, the difference of numbers of 1e-2 m

run::EvaluatedState last_state(const Bench& bench) {
  bench.run();
  const auto file = bench.options.out / "final_state.h5";
  return run::evaluated_state(state_file::read_state(file), file, host());
}

struct Disc {
  double x, y, radius;
};

Disc disc(const pictures::Frame& frame, std::int64_t id) {
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    if (frame.id[i] == id) return {frame.position[3 * i], frame.position[3 * i + 1], frame.radius[i]};
  FAIL("no such disc");
  return {};
}

}  // namespace

TEST_CASE("contacts of a state without forces have the forces of their law, with ids, walls and points",
          "[run]") {
  const run::EvaluatedState state = last_state(Bench(two_discs));
  CHECK_FALSE(state.has_forces);
  const pictures::Frame& frame = state.frame;
  REQUIRE(frame.contact_count() == 2);
  for (std::size_t c = 0; c < 2; ++c) {
    const Disc a = disc(frame, frame.contact_a[c]);
    const bool wall = frame.contact_wall[c] >= 0;
    CHECK((frame.contact_b[c] == -1) == wall);
    if (wall) CHECK((frame.contact_a[c] == 7 && frame.walls[0].name == "floor"));
    const Disc b = wall ? Disc{a.x, 0, 0} : disc(frame, frame.contact_b[c]);
    const double dx = a.x - b.x, dy = a.y - b.y, distance = std::hypot(dx, dy);
    const double overlap = a.radius + b.radius - distance;
    CHECK(frame.contact_overlap[c] == Approx(overlap).epsilon(overlap_round_off));
    CHECK(frame.contact_normal[3 * c] == Approx(dx / distance));
    CHECK(frame.contact_normal[3 * c + 1] == Approx(dy / distance));
    CHECK(frame.contact_force[3 * c] ==
          Approx(disc_stiffness * overlap * dx / distance).epsilon(overlap_round_off));
    CHECK(frame.contact_force[3 * c + 1] ==
          Approx(disc_stiffness * overlap * dy / distance).epsilon(overlap_round_off));
    const double arm = (distance + a.radius - b.radius) / 2;  // to the middle of the overlap
    CHECK(frame.contact_point[3 * c] == Approx(a.x - (wall ? a.radius - overlap / 2 : arm) * dx / distance));
    CHECK(frame.contact_point[3 * c + 1] ==
          Approx(a.y - (wall ? a.radius - overlap / 2 : arm) * dy / distance));
  }
}

TEST_CASE("contacts of a state with forces have those, and what slides is the same without them", "[run]") {
  const std::string sliding =
      with(with(two_discs, "normal_damping = 0\n",
                "normal_damping = 0\ntangential_stiffness = 1e4\nstatic_friction = 0.01\n"),
           "mass = 1\n[[boundary]]", "mass = 1\nvelocity = [1, 0]\n[[boundary]]");
  const run::EvaluatedState with_forces =
      last_state(Bench(sliding + "[[probe]]\nplugin = 'contacts'\nevery = 1e-5\n"));
  const run::EvaluatedState without = last_state(Bench(sliding));
  CHECK(with_forces.has_forces);
  CHECK_FALSE(without.has_forces);
  REQUIRE(with_forces.frame.contact_count() == 2);
  CHECK(with_forces.frame.contact_a == without.frame.contact_a);
  CHECK(with_forces.frame.contact_sliding == without.frame.contact_sliding);
  CHECK(with_forces.frame.contact_sliding[0] == 1);
  // Springs alone, at the limit of friction, which an evaluation without a motion leaves where they are.
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(without.frame.contact_force[k] ==
          Approx(with_forces.frame.contact_force[k]).epsilon(1e-9).margin(1e-12));
}

TEST_CASE("the simulation of a state has forces on bodies that are those of its contacts, and goes on",
          "[run]") {
  for (const char* probe : {"", "[[probe]]\nplugin = 'contacts'\nevery = 1e-5\n"}) {
    const Bench bench(two_discs + probe);
    const run::EvaluatedState state = last_state(bench);
    const auto file = bench.options.out / "final_state.h5";
    const run::EvaluatedSimulation evaluated =
        run::evaluated_simulation(state_file::read_state(file), file, host());
    CHECK(evaluated.has_forces == (*probe != 0));
    const ContactList list = evaluated.simulation->contact_list();
    CHECK(list.force == state.frame.contact_force);
    double sum = 0;
    for (std::size_t c = 0; c < list.size(); ++c)
      if (list.b[c] >= 2) sum += list.force[3 * c + 1];
    double load = 0;
    for (std::size_t i = 0; i < 2; ++i) load += evaluated.simulation->particles().force()[1][i];
    CHECK(sum > 0);
    CHECK(load == Approx(sum));
    evaluated.simulation->step();
    CHECK(evaluated.simulation->steps() == state.frame.step + 1);
  }
}

TEST_CASE("contacts are not evaluated from the state of something else than a run", "[run]") {
  State state;
  state.put("quasi_static/scenario", {std::vector<std::string>{""}, {}, ""});
  CHECK(message([&] {
          run::evaluated_state(state, "other.h5", host());
        }).starts_with("other.h5: is not the state of a run, from which contacts are evaluated; give"));
}
