#include "error_line.hpp"
#include "layer_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Five bodies in a box that is periodic along y, all at 8 m/s: in 0.4 s each travels 3.2 periods.
Scene carried(int dimension) {
  std::vector<Body> bodies;
  for (const double y : {0.95, 0.05, 0.25, 0.5, 0.75}) {
    const Vec3 x = {{0.1 + 0.15 * double(bodies.size()), y, dimension == 3 ? 0.5 : 0}};
    bodies.push_back(body(std::int64_t(bodies.size()) + 1, 0.01, 1, x, {{0, 8, 0}}, {}, dimension));
  }
  Scene s = scene(dimension, lattice_step, bodies, lattice_law);
  add_boundary(s, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}, {"axes", {1}}});
  return s;
}

}  // namespace

TEST_CASE("layer: a layer of a uniformly strained lattice moves as the lattice does at its height",
          "[layer]") {
  for (const int dimension : {2, 3})
    for (int axis = 0; axis < dimension; ++axis) {
      Simulation s(lattice_in_box(dimension, axis));
      const Values common = {{"axis", {double(axis)}}, {"half_width", {0.11}}};
      Values by_height = common, by_share = common;
      by_height.push_back({"at", {0.25}});
      by_share.push_back({"at_share", {0.25}});
      Probe at = probe_of("layer", by_height, dimension), share = probe_of("layer", by_share, dimension);
      for (Probe* p : {&at, &share}) {
        const Sampled first = sampled(*p, s);
        CHECK(first["bodies"] == 6);  // at 0.15, 0.25 and 0.35 m
        CHECK(first["displacement"] == 0);
      }
      run(s, 400);
      const double velocity = lattice_rate * (0.25 - 0.5), moved = 0.4 * velocity;
      for (Probe* p : {&at, &share}) {
        const Sampled last = sampled(*p, s);
        CHECK(last["bodies"] == 6);
        CHECK(last["displacement"] == near(moved, lattice_rounding));
        CHECK(last["position"] == near(0.25 + moved, lattice_rounding));
        CHECK(last["velocity"] == near(velocity, lattice_rounding));
      }
    }
}

TEST_CASE("layer: y is the axis without any, and shares count between the innermost walls", "[layer]") {
  Scene sc = lattice_in_box(3, 1);
  add_boundary(sc, "plane", {{"point", {0, 0.02, 0}}, {"normal", {0, 1, 0}}});
  const Simulation s(sc);
  // 0.02 + 0.5 × 0.98 = 0.51 m: the bodies at 0.55 m only; from the outer wall those at 0.45 m too.
  const Sampled layer = sample(s, "layer", {{"at_share", {0.5}}, {"half_width", {0.055}}});
  CHECK(layer["bodies"] == 2);
  CHECK(layer["position"] == near(0.55, lattice_rounding));
}

TEST_CASE("layer: bodies on both sides of a periodic face are one layer, and follow their paths", "[layer]") {
  for (const int dimension : {2, 3})
    for (const double at : {0.0, 1.0}) {
      Simulation s(carried(dimension));
      Probe p = probe_of("layer", {{"at", {at}}, {"half_width", {0.06}}}, dimension);
      CHECK(sampled(p, s)["bodies"] == 2);
      CHECK(sampled(p, s)["position"] == near(at, lattice_rounding));
      run(s, 400);
      REQUIRE(s.particles().image[1][0] == 4);
      REQUIRE(s.particles().image[1][1] == 3);
      // Paths of 4.2 m take up to 4 times the rounding of the box.
      CHECK(sampled(p, s)["position"] == near(at + 3.2, 5 * lattice_rounding));
      CHECK(sampled(p, s)["displacement"] == near(3.2, 5 * lattice_rounding));
      CHECK(sampled(p, s)["velocity"] == 8);
      CHECK_FALSE(p.observes());
    }
}

TEST_CASE("layer: the bodies are those of the start, also after a resume", "[layer]") {
  Simulation s(carried(2));
  const Values values = {{"at", {0.0}}, {"half_width", {0.06}}};
  Probe p = probe_of("layer", values, 2);
  sampled(p, s);
  run(s, 150);
  Probe q = resumed(p, "layer", values, s);
  run(s, 250);
  CHECK(sampled(q, s).row == sampled(p, s).row);
  CHECK(sampled(q, s)["displacement"] == near(3.2, 5 * lattice_rounding));
}

TEST_CASE("layer: a probe that starts later takes the bodies that are there then, in the box", "[layer]") {
  Simulation s(carried(3));
  run(s, 250);  // two periods: each body is where it was, in another image
  REQUIRE(s.particles().image[1][0] >= 2);
  Probe p = probe_of("layer", {{"at", {0.0}}, {"half_width", {0.06}}}, 3);
  CHECK(sampled(p, s)["bodies"] == 2);
  CHECK(sampled(p, s)["displacement"] == 0);
  CHECK(sampled(p, s)["position"] == near(0, 5 * lattice_rounding));
  run(s, 150);
  CHECK(sampled(p, s)["position"] == near(1.2, 5 * lattice_rounding));
}

TEST_CASE("layer: sampling leaves the motion as it is", "[layer]") {
  CHECK(leaves_the_motion("layer", {{"at", {0.3}}, {"half_width", {0.1}}}));
}

TEST_CASE("layer: what has no bodies or no walls is refused with a remedy", "[layer]") {
  using Catch::Contains;
  const Simulation s(lattice(3, 1)), flat(lattice(2, 1)), none(scene(3, 1e-3, {}, lattice_law));
  const auto refusal = [](const Simulation& in, const Values& values) {
    try {
      sample(in, "layer", values);
    } catch (const std::exception& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string empty = refusal(s, {{"at", {0.32}}, {"half_width", {0.01}}});
  CHECK_THAT(empty, Contains("no body lies within half_width = 0.01 m of y = 0.32 m") &&
                        Contains("nearest is body 7 at y = 0.35 m") && Contains("above 0.03 m"));
  CHECK_THAT(refusal(none, {{"at", {0.3}}, {"half_width", {0.01}}}), Contains("there are no bodies"));
  CHECK_THAT(refusal(s, {{"at_share", {0.3}}, {"half_width", {0.01}}}),
             Contains("at_share needs walls at both ends of y; give at (m)"));
  CHECK_THAT(refusal(flat, {{"axis", {2}}, {"at", {0.3}}, {"half_width", {0.01}}}), Contains("no z axis"));
  CHECK_THAT(refusal(s, {{"at", {0.3}}, {"at_share", {0.3}}, {"half_width", {0.1}}}), Contains("at_share"));
  CHECK_THAT(refusal(s, {{"half_width", {0.1}}}), Contains("at"));
}

TEST_CASE("layer: has only bodies that a scenario chooses, also after an interruption", "[layer]") {
  const Simulation s(lattice_in_box(3, 1));
  const Values values = {{"at", {0.25}}, {"half_width", {0.11}}};
  // Of the six bodies at 0.15, 0.25 and 0.35 m the first of each two, and not the first of all.
  std::vector<std::uint8_t> left_out(s.particles().size(), 0);
  for (std::size_t i = 1; i < left_out.size(); i += 2) left_out[i] = 1;
  left_out[2] = 1;
  Probe probe(parameters("layer", SCREE_PROBE, values), 3, left_out);
  const Sampled layer = sampled(probe, s);
  CHECK(layer["bodies"] == 2);
  CHECK(layer["position"] == near(0.3, lattice_rounding));
  CHECK(sampled(probe, s).row == layer.row);

  State state;
  probe.transfer(StateTransfer::saving_to(state).below("probe"));
  Probe again(parameters("layer", SCREE_PROBE, values), 3, left_out);
  again.transfer(StateTransfer::restoring_from(state).below("probe"));
  again.check_restored(SimulationView(s, 0).get());
  CHECK(sampled(again, s).row == layer.row);
}

TEST_CASE("layer: a body that is left out is not offered as the nearest", "[layer]") {
  const Simulation s(carried(2));
  const auto refused_by = [&](std::vector<std::uint8_t> left_out) {
    Probe probe(parameters("layer", SCREE_PROBE, {{"at", {0.6}}, {"half_width", {0.05}}}), 2,
                std::move(left_out));
    return error_line([&] { sampled(probe, s); });
  };
  CHECK_THAT(refused_by({0, 0, 0, 0, 0}), Catch::Contains("the nearest is body 4 at"));
  CHECK_THAT(refused_by({0, 0, 0, 1, 0}), Catch::Contains("the nearest is body 5 at"));
}
