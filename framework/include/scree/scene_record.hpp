#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <scree/scene.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

// The scene in the state of a simulation:
//   scene/       dimension, integrator, materials, plug-ins with names and parameter values, and groups
//   bodies/      id, material, radius, mass, inertia and, if there are any, fixed and held, which are constant
//   start/       position, velocity and spin at t = 0, from which limits of the scene follow; velocity and
//                spin only if not all are 0
//   selections/  names and bodies of groups that probes count or leave out, if there are any

void save_scene(const StateTransfer& state, const Scene& scene);
void save_bodies_at_start(const StateTransfer& state, const Scene& scene);

// Throws Error if a state belongs to another scene: it names what differs.
void check_scene(const State& state, const Scene& scene);
bool is_scene_of(const State& state, const Scene& scene);
// Likewise of its contact laws alone.
bool has_laws_of(const State& state, const Scene& scene);

// What a state records of a law or a boundary.
struct RecordedPlugin {
  std::string name, plugin;
  std::vector<std::string> parameters;  // see parameter_lines
};
// Throw Error if these arrays do not fit one another.
std::vector<RecordedPlugin> recorded_laws(const State& state);
std::vector<RecordedPlugin> recorded_boundaries(const State& state);
std::vector<RecordedPlugin> recorded_body_forces(const State& state);
int dimension_of(const State& state);
std::vector<std::int64_t> recorded_ids(const State& state);

// The bodies at t = 0. Throws Error if an array is missing or has another size.
std::vector<Body> bodies_at_start(const State& state);

// The groups that move or load bodies.
std::vector<BodyGroup> groups_of(const State& state);
std::vector<BodyGroup> groups_of(const State& state, std::size_t bodies);  // of a state without bodies
std::vector<BodySelection> selections_of(const State& state);

// What a run that goes on takes from its state in place of files and the tables of bodies. Throws Error as
// bodies_at_start().
struct RecordedBodies {
  std::vector<Body> bodies;  // at t = 0
  std::vector<BodyGroup> groups;
  std::vector<BodySelection> selections;
  std::vector<RecordedPlugin> boundaries;  // which have the meshes
};
RecordedBodies recorded_bodies(const State& state);

// "key = value" of every parameter, with defaults; and the parameters that such lines give.
std::vector<std::string> parameter_lines(const Parameters& parameters);
Parameters parameters_of(const scree_plugin& plugin, const std::vector<std::string>& lines);
// The numbers of "key = 1, 2". Throws Error if they are none.
std::vector<double> numbers_of_line(const std::string& line);

}  // namespace scree
