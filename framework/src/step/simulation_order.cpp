#include "step/simulation_parts.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <scree/state_transfer.hpp>

// Where the bodies of a simulation are in memory, and copies in the order of the scene.
namespace scree {

// The numbers of the bodies in memory, if they are rearranged.
void SimulationParts::transfer_order(const StateTransfer& bodies) {
  const char* const name = "number_in_memory";
  if (!(bodies.restoring() ? bodies.has(name) : particles.order().rearranged())) return;
  std::vector<std::uint32_t> numbers = particles.order().numbers();
  bodies.rows(name, "", numbers);
  if (!bodies.restoring()) return;
  std::vector<std::uint8_t> found(particles.size(), 0);
  for (const std::uint32_t number : numbers)
    if (number < found.size()) found[number] = 1;
  if (numbers.size() != found.size() || std::count(found.begin(), found.end(), 0) > 0)
    bodies.refuse(name, "does not list each body once");
  rearrange(numbers);
}

void SimulationParts::rearrange(const std::vector<std::uint32_t>& from) {
  // The first rank knows the constants of all bodies.
  const std::vector<BodyRange> all = {{0, particles.size()}};
  const std::vector<BodyRange> kept = share && share->is_first() ? all : own_places();
  particles.rearrange(from, kept);
  driven.rearrange(from);
  integrator->rearrange(from, kept);
  contacts.rearrange(from);
  neighbours.rearrange(from, kept);
  forget_copies();
}

void SimulationParts::sort_bodies() {
  const std::vector<std::uint32_t> from = neighbours.better_order();
  if (share) send_bodies_for_good(RowRoutes::to_places(*share, BodyTiles(particles.size()), from));
  rearrange(from);
  PairColumns nothing;
  if (share) contacts.send_to_owners(share->ranks, share->owners, nothing, 0);
  neighbours.rebuild(particles, boundaries, contacts, *threads);
}

Particles& SimulationParts::all_bodies() {
  if (share && !bodies_are_gathered) {
    command(RankCommand::gather_bodies);
    gather_bodies();
  }
  return copy_is_current ? *copy_in_scene_order : particles;
}

Particles& SimulationParts::in_scene_order() {
  Particles& bodies = all_bodies();
  if (!bodies.order().rearranged()) return bodies;
  if (!copy_in_scene_order) copy_in_scene_order = particles;
  particles.copy_in_scene_order(*copy_in_scene_order);
  copy_is_current = true;
  return *copy_in_scene_order;
}

Particles& SimulationParts::in_scene_order(const std::vector<std::uint32_t>& numbers) {
  if (share && !bodies_are_gathered) {
    command(RankCommand::gather_listed);
    gather_listed(numbers);
  }
  if (!particles.order().rearranged()) return particles;
  if (copy_in_scene_order && !copy_is_current) {
    particles.copy_in_scene_order(*copy_in_scene_order, numbers);
  } else if (!copy_in_scene_order) {
    copy_in_scene_order = particles;
    particles.copy_in_scene_order(*copy_in_scene_order);
  }
  return *copy_in_scene_order;
}

}  // namespace scree
