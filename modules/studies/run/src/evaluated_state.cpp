#include <cstdint>
#include <vector>

#include <scree/error.hpp>
#include <scree/run/evaluated_state.hpp>
#include <scree/run/frame_of.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_error.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace {

constexpr const char* forces = "contacts/force";
constexpr const char* rows_of_forces = "contacts/force_row";

scenario::Plan plan_of(const State& state, const std::filesystem::path& file, PluginHost& host) {
  const StateTransfer run = StateTransfer::restoring_from(state).below("run");
  if (!run.has("scenario"))
    throw Error(file.string(), "is not the state of a run, from which contacts are evaluated",
                "give a final_state.h5 or a file of checkpoint/ or states/");
  std::string text;
  run.value("scenario", "", text);
  scenario::Plan plan =
      scenario::read_plan_again(text, file.string() + " (scenario)", {}, recorded_bodies(state), host);
  plan.scene.pair_forces = true;
  return plan;
}

// The state with forces of no contact, which its simulation takes and then evaluates.
State with_room_for_forces(State state, const Scene& scene) {
  state.put(rows_of_forces, {std::vector<std::uint32_t>(), {0}, ""});
  state.put(forces, {std::vector<double>(), {0, std::size_t(scene.dimension)}, "N"});
  return state;
}

// The simulation of a state, with the forces that it has or with room for others.
std::unique_ptr<Simulation> simulation_with_room(const State& state, const scenario::Plan& plan) {
  const State whole = state.has(rows_of_forces) ? state : with_room_for_forces(state, plan.scene);
  return resumed(plan, whole, StateTransfer::restoring_from(whole).below("run/stages"), 1);
}

EvaluatedState evaluated(const State& state, const std::filesystem::path& file, PluginHost& host) {
  const scenario::Plan plan = plan_of(state, file, host);
  const bool has_forces = state.has(rows_of_forces);
  const std::unique_ptr<Simulation> simulation = simulation_with_room(state, plan);
  const auto frame = [&] { return frame_of(*simulation, plan.title, scene_box(*simulation)); };
  EvaluatedState result = {frame(), has_forces};
  if (has_forces) return result;
  const std::vector<std::uint8_t> sliding = std::move(result.frame.contact_sliding);
  simulation->apply_reconfiguration();
  result.frame = frame();
  // Evaluated without a motion, contacts at the limit of friction stick.
  if (result.frame.contact_sliding.size() == sliding.size()) result.frame.contact_sliding = sliding;
  return result;
}

}  // namespace

EvaluatedState evaluated_state(const State& state, const std::filesystem::path& file, PluginHost& host) {
  return with_state_of(file.string(), [&] { return evaluated(state, file, host); });
}

EvaluatedSimulation evaluated_simulation(const State& state, const std::filesystem::path& file,
                                         PluginHost& host) {
  return with_state_of(file.string(), [&] {
    EvaluatedSimulation result = {simulation_with_room(state, plan_of(state, file, host)),
                                  state.has(rows_of_forces)};
    if (!result.has_forces) result.simulation->apply_reconfiguration();
    return result;
  });
}

}  // namespace scree::run
