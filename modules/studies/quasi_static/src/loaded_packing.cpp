#include "loaded_packing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>

#include <scree/energy.hpp>
#include <scree/stage.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::quasi_static {

namespace {

using response::QuasiStatic;

// Kinetic over elastic energy below which a moving packing may be taken to be at rest: its motion is lost
// there.
constexpr double at_rest = 1e-6;

Sample sample_of(const QuasiStatic& balance, double time) {
  return {.time = time,
          .planes = balance.planes(),
          .loads = balance.loads(),
          .frames = balance.frames(),
          .surface_loads = balance.surface_loads(),
          .absent = balance.absent_walls(),
          .contacts = balance.touching(),
          .sliding = balance.sliding()};
}

Sample sample_of(const Simulation& moving, double time) {
  const std::vector<std::uint8_t> sliding = moving.contact_list().sliding;
  return {.time = time,
          .planes = moving.planes(),
          .loads = moving.loads(),
          .frames = moving.surfaces().frames,
          .surface_loads = moving.surfaces().loads,
          .absent = moving.absent_walls(),
          .contacts = sliding.size(),
          .sliding = std::size_t(std::count(sliding.begin(), sliding.end(), 1)),
          .dynamic = true};
}

}  // namespace

LoadedPacking::LoadedPacking(const scenario::Plan& plan, unsigned threads, std::function<bool()> proceed,
                             FollowedLoad& load)
    : plan_(plan), threads_(threads), proceed_(std::move(proceed)), load_(load) {}

std::optional<Sample> LoadedPacking::advance(double time) {
  if (!moves_ && balance_->advance(time)) return sample_of(*balance_, time);
  if (!proceed_()) return std::nullopt;
  if (!moves_) {
    const State state = this->state();
    end_search();  // before its simulation is replaced
    simulation_ = simulation_of(state);
    begin_motion();
  }
  return move_to(time) ? seek_balance(time) : std::nullopt;
}

bool LoadedPacking::begin(std::unique_ptr<Simulation> simulation) {
  simulation_ = std::move(simulation);
  return balance();
}

void LoadedPacking::begin(const State& state, bool moves) {
  simulation_ = simulation_of(state);
  moves_ = moves;
  if (!moves_) balance();
}

void LoadedPacking::begin_part(const std::function<void(const State&)>& keep) {
  const State state = this->state();
  end_search();
  keep(state);
  if (!moves_) begin(state, false);
}

// Balance at the time of the simulation, from which the packing goes on. Returns false if there is none: then
// it moves.
bool LoadedPacking::balance() {
  balance_ = std::make_unique<QuasiStatic>(
      *simulation_, response::QuasiStaticOptions{.longest_increment = load_.increment, .proceed = proceed_});
  load_.degrees_of_freedom = balance_->degrees_of_freedom();
  if (balance_->advance(simulation_->time()) || !proceed_()) return true;
  begin_motion();
  return false;
}

void LoadedPacking::begin_motion() {
  end_search();
  moves_ = true;
  load_.hand_overs.push_back({simulation_->time(), simulation_->time()});
}

bool LoadedPacking::move_to(double time) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto steps = std::llround((time - simulation_->time()) / simulation_->step_length());
  load_.dynamic_steps += simulation_->run(std::uint64_t(steps), proceed_);
  load_.hand_overs.back().to = simulation_->time();
  load_.dynamic_wall_time += std::chrono::duration<double>(Clock::now() - begin).count();
  return proceed_();
}

// Of a packing that moves and has come to rest.
std::optional<Sample> LoadedPacking::seek_balance(double time) {
  const scree_energy energy = simulation_->energy();
  if (kinetic_energy(energy) > at_rest * elastic_energy(energy)) return sample_of(*simulation_, time);
  balance_ = std::make_unique<QuasiStatic>(
      *simulation_, response::QuasiStaticOptions{.longest_increment = load_.increment, .proceed = proceed_});
  const bool found = balance_->advance(std::max(time, simulation_->time())), stopped = !proceed_();
  std::optional<Sample> sample;
  if (!stopped) sample = found ? sample_of(*balance_, time) : sample_of(*simulation_, time);
  moves_ = !found || stopped;
  if (moves_) end_search();
  return sample;
}

void LoadedPacking::end_search() {
  if (!balance_) return;
  load_.increments += balance_->counts().increments;
  load_.iterations += balance_->counts().iterations;
  load_.events += balance_->counts().events;
  balance_.reset();
}

Sample LoadedPacking::sample(double time) const {
  return moves_ ? sample_of(*simulation_, time) : sample_of(*balance_, time);
}

const std::vector<std::string>& LoadedPacking::surface_names() const { return simulation_->surfaces().names; }

State LoadedPacking::state() const { return moves_ ? simulation_->state() : balance_->state(); }

std::unique_ptr<Simulation> LoadedPacking::simulation_of(const State& state) const {
  Scene scene = scene_in_stage(plan_.scene, plan_.stages, plan_.stages.size() - 1);
  scene.threads = threads_;
  return std::make_unique<Simulation>(scene, state);
}

}  // namespace scree::quasi_static
