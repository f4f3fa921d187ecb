#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scree/pictures/frame.hpp>
#include <scree/plugin_host.hpp>
#include <scree/simulation.hpp>
#include <scree/state.hpp>

namespace scree::run {

struct EvaluatedState {
  pictures::Frame frame;
  bool has_forces = false;  // the state has them; else they were evaluated
};

// The state of a run as a frame with its contacts. Forces that the state does not have, since nothing in its
// scene reads them, are evaluated from its positions, velocities and springs. They differ from those of a run
// by the error of a step, since a step evaluates with velocities that it predicts, and weights the forces of
// a contact that begins in it. file: of the state, for messages. Throws Error if it is not the state of a
// run, or its plug-ins are missing.
EvaluatedState evaluated_state(const State& state, const std::filesystem::path& file, PluginHost& host);

struct EvaluatedSimulation {
  std::unique_ptr<Simulation> simulation;
  bool has_forces = false;  // the state has them; else they were evaluated
};

// The same as a simulation, which can take a step. Forces on bodies are those of the contacts. Throws Error
// as evaluated_state().
EvaluatedSimulation evaluated_simulation(const State& state, const std::filesystem::path& file,
                                         PluginHost& host);

}  // namespace scree::run
