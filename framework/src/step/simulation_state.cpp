#include "contacts/contacts.hpp"
#include "step/simulation_parts.hpp"

#include <future>

#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>
#include <scree/state_hash.hpp>
#include <scree/state_transfer.hpp>
#include <scree/threads.hpp>

namespace scree {

State Simulation::state() const {
  State state = changing_state();
  add_unchanging_state(state);
  return state;
}

State Simulation::changing_state() const {
  parts_->in_scene_order();  // before threads read them
  parts_->all_pairs();
  parts_->gather_sliding_work();
  // Three parts that take about equally long.
  std::future<State> pairs_copied = in_background([this] {
    State pairs;
    parts_->transfer_pairs(StateTransfer::saving_to(pairs));
    return pairs;
  });
  std::future<std::uint64_t> hashed = in_background([this] { return state_hash(); });
  State state;
  const StateTransfer to = StateTransfer::saving_to(state);
  save_scene(to.below("scene"), parts_->scene);
  parts_->transfer_all_but_pairs(to);
  std::uint64_t hash = hashed.get();
  to.value("state_hash", "", hash);
  state.merge(pairs_copied.get());
  return state;
}

void Simulation::add_unchanging_state(State& state) const {
  save_bodies_at_start(StateTransfer::saving_to(state), parts_->scene);
}

State Simulation::state_at_rest(const RestingPacking& packing) const {
  Simulation moved(scene(), state());
  moved.parts_->come_to_rest(packing);
  return moved.state();
}

std::uint64_t Simulation::state_hash() const {
  StateHash hash;
  hash.add(steps());
  // No copy in scene order is made for this: it takes as much memory again.
  const Particles& p = parts_->all_bodies();
  const BodyOrder& order = p.order();
  const auto add_column = [&](const auto& column) {
    for (std::size_t number = 0; number < column.size(); ++number) hash.add(column[order.place(number)]);
  };
  for (const auto& vectors : {p.position(), p.velocity(), p.spin()})
    for (int k = 0; k < 3; ++k) add_column(vectors[k]);
  for (int k = 0; k < p.orientations.components(); ++k) add_column(p.orientations[k]);
  for (std::size_t number = 0; number < p.fixed.size(); ++number)
    hash.add(std::uint64_t(p.fixed[order.place(number)]));
  for (std::size_t number = 0; number < p.held.size(); ++number)
    hash.add(std::uint64_t(p.held[order.place(number)]));
  parts_->integrator->add_to_hash(hash, parts_->particles.order());
  parts_->add_histories(hash);
  parts_->boundaries.add_to_hash(hash);
  return hash.value();
}

}  // namespace scree
