#include "ranks/balanced_owners.hpp"
#include "ranks/row_routes.hpp"
#include "state/scene_message.hpp"
#include "state/state_bytes.hpp"
#include "step/simulation_parts.hpp"
#include "surfaces/sliding_work.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <scree/follow_first_rank.hpp>
#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

// How several ranks compute a simulation.
namespace scree {

namespace {

// Tiles are dealt anew if the busiest rank has worked for so much longer than the mean, and for so long (s).
constexpr double largest_imbalance = 1.1, least_measured = 0.1;

// Of evaluating a tile: its pairs, and its bodies, each of which takes about as long.
std::size_t work_in(const Contacts& contacts, const BodyTiles& tiles, std::size_t tile) {
  std::size_t work = tiles[tile].end - tiles[tile].begin;
  for (const PairGroup& group : contacts.groups())
    if (!group.runs.empty()) work += group.runs[tile].end - group.runs[tile].begin;
  return work;
}

void broadcast_state(Ranks& ranks, const State& state) {
  std::vector<std::byte> bytes = bytes_of(state);
  std::uint64_t size = bytes.size();
  ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
  ranks.broadcast(bytes);
}

}  // namespace

void Simulation::share_with(Ranks* ranks) {
  if (!ranks) return;
  SimulationParts& p = *parts_;
  send_command(*ranks, RankCommand::begin);
  broadcast_state(*ranks, message_of(p.scene, p.facts));
  State shared;
  p.transfer_shared(StateTransfer::saving_to(shared));
  broadcast_state(*ranks, shared);
  p.share_with(*ranks);
  p.deal_tiles(p.balanced_owners(1));
}

Simulation::~Simulation() {
  try {
    if (parts_) parts_->command(RankCommand::end);
  } catch (...) {
    // Ranks that cannot be reached end by themselves.
  }
}

bool Simulation::is_interrupted_elsewhere() const {
  return parts_->share && parts_->share->other_is_interrupted;
}

FirstRank::~FirstRank() {
  try {
    if (ranks_) send_command(*ranks_, RankCommand::leave);
  } catch (...) {
    // Ranks that cannot be reached end by themselves.
  }
}

void SimulationParts::transfer_shared(const StateTransfer& state) {
  transfer_common(state);
  transfer_order(state.below("bodies"));
  driven.transfer(state.below("driven"), particles.size());
  // Not before the first search.
  if (state.restoring() ? state.has("neighbours/skin") : neighbours.rebuilds() > 0)
    neighbours.transfer_but_bodies(state.below("neighbours"), particles, boundaries);
}

void SimulationParts::share_with(Ranks& ranks) {
  const std::size_t tiles = BodyTiles(particles.size()).count();
  share.emplace(RankShare{ranks, TileOwners(std::vector<std::uint32_t>(tiles, 0), ranks.rank())});
  neighbours.share_with_ranks(*share, particles.size(), [this] { forces.bring_bodies_of_others(particles); });
  forces.share_with_ranks(*share);
  displaced_loads.reset();
  stepper.take_own_parts();
}

TileOwners SimulationParts::balanced_owners(double weight) const {
  std::vector<double> work(share->owners.tiles(), -std::numeric_limits<double>::infinity());
  for (const std::uint32_t tile : share->owners.own())
    work[tile] = weight * double(work_in(contacts, BodyTiles(particles.size()), tile));
  return scree::balanced_owners(share->ranks, {std::move(work), contacts.edges_of_tiles()});
}

void SimulationParts::deal_tiles(TileOwners next) {
  send_bodies_for_good(RowRoutes::to_owners(*share, BodyTiles(particles.size()), next));
  // After a search the forces are of other pairs, and an evaluation follows.
  bool with_forces = forces.are_of(contacts);
  share->ranks.broadcast(std::as_writable_bytes(std::span(&with_forces, 1)));
  PairColumns of_pairs = with_forces ? forces.pair_forces() : PairColumns();
  contacts.send_to_owners(share->ranks, next, of_pairs, with_forces ? forces.columns() : 0);
  share->dealt_after = neighbours.rebuilds();
  share->owners = std::move(next);
  neighbours.forget_near_bodies();
  forces.update_pairs(particles, contacts, reads_of(laws), boundaries.wall_count(), *threads);
  if (with_forces && forces.columns() > 0) forces.pair_forces() = std::move(of_pairs);
  stepper.take_own_parts();
  share->busy = 0;
}

void SimulationParts::deal_after_search() {
  share->dealt_after = neighbours.rebuilds();
  if (share->ranks.deals_at_random())
    return deal_tiles(TileOwners::at_random(share->owners.tiles(), share->ranks.size(), share->ranks.rank(),
                                            share->dealt_after));
  const Load busy = load_of_ranks(share->busy);
  if (busy.most < least_measured || busy.most < largest_imbalance * busy.mean) return;
  const double work = own_work();
  // A rank without tiles has measured nothing, and none depends on its weight.
  deal_tiles(balanced_owners(work > 0 ? share->busy / work : 1));
}

void SimulationParts::deal_by_pairs() {
  const Load work = load_of_ranks(own_work());
  TileOwners next = balanced_owners(1);
  if (next.by_graph() || work.most > largest_imbalance * work.mean) deal_tiles(std::move(next));
}

double SimulationParts::own_work() const {
  double work = 0;
  for (const std::uint32_t tile : share->owners.own())
    work += double(work_in(contacts, BodyTiles(particles.size()), tile));
  return work;
}

SimulationParts::Load SimulationParts::load_of_ranks(double own) const {
  constexpr double counted = 1e4;  // of a second or of a pair: sums are whole numbers
  double most = own;
  std::int64_t sum = std::int64_t(counted * own);
  share->ranks.combine({&most, 1}, {&sum, 1});
  return {most, double(sum) / counted / share->ranks.size()};
}

void SimulationParts::send_bodies(const RowRoutes& routes) {
  particles.send(share->ranks, routes);
  integrator->send(share->ranks, routes, particles.size());
  neighbours.send(routes);
}

void SimulationParts::send_bodies_for_good(const RowRoutes& routes) {
  particles.send_constants(share->ranks, routes);
  send_bodies(routes);
}

std::vector<BodyRange> SimulationParts::own_places() const {
  if (!share) return {{0, particles.size()}};
  std::vector<BodyRange> places;
  for (const std::uint32_t tile : share->owners.own()) places.push_back(BodyTiles(particles.size())[tile]);
  return places;
}

void SimulationParts::gather_bodies() {
  send_bodies(RowRoutes::to_first(*share, BodyTiles(particles.size())));
  bodies_are_gathered = true;
}

void SimulationParts::gather_listed(const std::vector<std::uint32_t>& numbers) {
  // Mostly the same bodies as the last time.
  std::uint64_t changed = share->is_first() && numbers != listed_bodies;
  share->ranks.broadcast(std::as_writable_bytes(std::span(&changed, 1)));
  if (changed) {
    std::uint64_t size = numbers.size();
    share->ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
    if (share->is_first()) listed_bodies = numbers;
    listed_bodies.resize(size);
    share->ranks.broadcast(std::as_writable_bytes(std::span(listed_bodies)));
  }
  std::vector<std::uint32_t> places;
  for (const std::uint32_t number : listed_bodies) places.push_back(particles.order().place(number));
  std::sort(places.begin(), places.end());
  particles.send(share->ranks, RowRoutes::to_first(*share, BodyTiles(particles.size()), places));
}

void SimulationParts::gather_pairs() {
  gathered_contacts = contacts;
  gathered_forces = forces.pair_forces();
  const TileOwners first(share->owners.tiles());
  gathered_contacts->send_to_owners(share->ranks, first, gathered_forces, forces.columns());
  pairs_are_gathered = share->is_first();
  if (!share->is_first()) gathered_contacts.reset();
}

void SimulationParts::gather_sliding_work() {
  if (!share || !scene.sliding_work) return;
  command(RankCommand::gather_sliding_work);
  forces.sliding_work()->gather(share->ranks);
}

SimulationParts::Pairs SimulationParts::all_pairs() {
  if (!share) return {contacts, forces.pair_forces()};
  if (!pairs_are_gathered) {
    command(RankCommand::gather_pairs);
    gather_pairs();
  }
  return {*gathered_contacts, gathered_forces};
}

void SimulationParts::add_histories(StateHash& hash) {
  // Threads that save a state may not send messages, and have gathered the pairs before.
  if (pairs_are_gathered) return gathered_contacts->add_to_hash(hash, particles.order(), nullptr);
  command(RankCommand::add_histories);
  contacts.add_to_hash(hash, particles.order(), share ? &*share : nullptr);
}

SimulationParts::PairCounts SimulationParts::count_pairs() {
  if (share) forces.bring_bodies_of_others(particles);
  std::int64_t listed = std::int64_t(contacts.listed());
  std::int64_t touching = std::int64_t(count_touching(particles, contacts, boundaries));
  CrossingPairs of_bodies = contacts.crossing();
  RankSums sums(ranks());
  sums.total(listed);
  sums.total(touching);
  sums.total(of_bodies.all);
  sums.total(of_bodies.crossing);
  const Forces::Foreign here = forces.foreign();
  std::int64_t foreign = std::int64_t(here.bodies), sent = std::int64_t(here.bytes_sent);
  double bytes_per_pair = double(forces.bytes_per_pair());  // less on a rank without pairs
  sums.total(foreign);
  sums.total(sent);
  sums.largest(bytes_per_pair);
  sums.close();
  return {std::size_t(listed), std::size_t(touching), std::size_t(bytes_per_pair),
          of_bodies,           std::size_t(foreign),  std::size_t(sent)};
}

void SimulationParts::command_change(RankCommand change, const std::string& name,
                                     const Parameters& parameters,
                                     const std::vector<std::string>& going_on) const {
  if (!share) return;
  std::vector<std::string> lines = {name, fmt::format("{}", going_on.size())};
  lines.insert(lines.end(), going_on.begin(), going_on.end());
  const std::vector<std::string> own = parameter_lines(parameters);
  lines.insert(lines.end(), own.begin(), own.end());
  command(change, lines);
}

}  // namespace scree
