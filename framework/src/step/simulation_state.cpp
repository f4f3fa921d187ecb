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
  const Particles& p = particles();
  for (const auto& vectors : {p.position(), p.velocity(), p.spin()})
    for (int k = 0; k < 3; ++k)
      for (const double component : vectors[k]) hash.add(component);
  for (int k = 0; k < p.orientations.components(); ++k)
    for (const double component : p.orientations[k]) hash.add(component);
  for (const std::uint8_t fixed : p.fixed) hash.add(std::uint64_t(fixed));
  for (const freedom::Mask held : p.held) hash.add(std::uint64_t(held));
  const BodyOrder& order = parts_->particles.order();
  parts_->integrator->add_to_hash(hash, order);
  const Contacts& contacts = this->contacts();
  for (const PairGroup& group : contacts.groups())
    for (const std::size_t q : contacts.in_scene_order(group, order))
      for (std::uint32_t k = 0; k < group.history_width; ++k)
        if (const double value = group.history_of(q, k); value != 0) {
          const std::uint32_t b = group.planes ? contacts.b[q] : order.number(contacts.b[q]);
          hash.add((std::uint64_t(order.number(contacts.a[q])) << 32) | b);
          hash.add(std::uint64_t(k));
          hash.add(value);
        }
  parts_->boundaries.add_to_hash(hash);
  return hash.value();
}

}  // namespace scree
