#pragma once

#include "scenes.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/boundary.hpp>

// A boundary plug-in that goes wrong as a script says, in a scene of one body.
namespace scree::test {

// What the walls below saw and what they are to do wrong; plug-ins have no other way to the test.
struct Script {
  std::string fault = {};  // what goes wrong
  double bad = 0;          // the number that it puts there
  double from_time = 0;    // of faults during steps
  std::vector<std::string> calls = {};
  std::vector<double> times = {}, steps = {};
  std::vector<std::string> names = {};
  double time_before = 0;
  double other_height = 0, other_load = 0, domain_upper = 0, body_lower = 0;
};
inline Script script;

// A floor at z = 0 of mass 1 kg that moves with 1 m/s along x.
struct Scripted {
  double number = 0;

  static constexpr About about = {"scripted", "for tests", "—", "—"};
  static constexpr const char* names[] = {"only"};
  static constexpr const char* no_names[] = {nullptr};
  static inline double mass = 1;

  void declare(Declaration& d) { d.number("number", number, "", any_number, "a number"); }
  void describe(BoundaryLayout& layout) const {
    layout.walls = 1;
    layout.state = number > 0 ? 2 : 1;
    layout.names = script.fault == "name" ? no_names : names;
    mass = script.fault == "mass" ? script.bad : 1;
    layout.masses = &mass;
    if (script.fault == "still") layout.still = true;
    if (script.fault == "axis") layout.periodic[1] = {0, script.bad};
  }
  const char* start(const BoundaryStep& s) const {
    note("start", s);
    s.walls[0] = {{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, {{1, 0, 0}}};
    if (script.fault == "point at start") s.walls[0].point[2] = script.bad;
    if (script.fault == "normal at start") s.walls[0].normal[2] = script.bad;
    if (script.fault == "velocity at start") s.walls[0].velocity[2] = script.bad;
    s.energy.kinetic = 0.5;
    return script.fault == "refusal" ? "the wall has no ground; give it some" : nullptr;
  }
  void begin_step(const BoundaryStep& s) const {
    note("begin", s);
    s.walls[0].point += s.step * s.walls[0].velocity;
    if (script.fault == "point in step" && s.time >= script.from_time) s.walls[0].point[1] = script.bad;
  }
  void finish_step(const BoundaryStep& s) const {
    note("finish", s);
    s.energy.kinetic = 0.5;
    if (script.fault == "velocity at end" && s.time >= script.from_time) s.walls[0].velocity[0] = script.bad;
  }
  void change(const Scripted& before, double time_before, const BoundaryStep& s) const {
    note("change", s);
    CHECK(before.number != number);
    script.time_before = time_before;
    s.walls[0].velocity[0] = 3;
    s.energy.kinetic = 4.5;
    CHECK(s.state[0] == 7);
    if (s.state.size() > 1) CHECK(s.state[1] == (number > 0 ? 0 : 8));
    if (s.state.size() > 1) s.state[1] = 8;
  }

 protected:
  static void note(const char* call, const BoundaryStep& s) {
    script.calls.push_back(call);
    script.times.push_back(s.time);
    script.steps.push_back(s.step);
    s.state[0] = 7;
    const BoundaryScene scene = s.scene();
    script.names.assign(scene.names.begin(), scene.names.end());
    if (scene.walls.size() > 1) {
      script.other_height = scene.walls[0].point[2];
      script.other_load = scene.loads[0].force[2];
    }
    script.domain_upper = scene.periodic[1] ? scene.domain_upper[1] : 0;
    script.body_lower = scene.lower[2];
  }
};

template <class Author>
const scree_plugin& scripted() {
  using namespace scree::detail;
  static const scree_boundary interface = {sizeof(scree_boundary),
                                           sizeof(Author),
                                           &configure_boundary<Author>,
                                           &start_boundary<Author>,
                                           &begin_boundary_step<Author>,
                                           &finish_boundary_step<Author>,
                                           change_of<Author>(),
                                           linear_of<Author>(),
                                           rest_of<Author>()};
  return *manifest_of<Author>(SCREE_BOUNDARY, interface);
}

template <class Author = Scripted>
Parameters with_number(double number) {
  Parameters p(scripted<Author>());
  p.set("number", {number});
  return p;
}

template <class Author = Scripted>
Scene scene_with(const Script& now) {
  script = now;
  Scene s = scene(3, 1e-3, {body(1, 0.1, 1, {{0, 0.5, 5}})},
                  {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  s.boundaries.push_back({"mine", 0, with_number<Author>(0)});
  return s;
}

}  // namespace scree::test
