#include "contacts/displaced_loads.hpp"

#include "contacts/kernel/block.hpp"
#include "contacts/kernel/evaluate.hpp"
#include "ranks/rank_share.hpp"
#include "ranks/rank_sums.hpp"

namespace scree {

DisplacedLoads::DisplacedLoads(const Forces::Features& features, RankShare* share)
    : evaluate_(kernel::plane_load_evaluation(features)), share_(share) {}

scree_load DisplacedLoads::load(const Scene& scene, std::size_t plane, const double* displacement) {
  PlanePairs& pairs = pairs_of(scene, plane);
  std::size_t next = 0;
  for (const PairGroup& all : scene.contacts.groups()) {
    if (!all.planes || all.surfaces) continue;
    pairs.contacts.groups()[next].history.take(all.history, pairs.rows[next]);
    ++next;
  }
  planes_ = scene.planes;
  for (int k = 0; k < 3; ++k) {
    planes_[plane].point[k] += displacement[k];
    planes_[plane].velocity[k] = planes_[plane].mid_velocity[k] = displacement[k] / scene.step;
  }
  records_.set(planes_, scene.particles.width());
  const kernel::EvaluationInput input = {.contacts = pairs.contacts,
                                         .records = scene.particles.records(),
                                         .particles = scene.particles,
                                         .planes = records_,
                                         .domain = scene.domain,
                                         .shifts = nullptr,
                                         .periodic = false,
                                         .step = scene.step,
                                         .kick = scene.kick,
                                         .audit = false,
                                         .pair_forces = false,
                                         .max_overlap_ratio = 0};
  std::vector<scree_load> of_tiles(BodyTiles(scene.particles.size()).count(), scree_load{});
  const auto evaluate = [&](std::size_t tile) {
    evaluate_({.input = &input,
               .tiles = nullptr,
               .tile = tile,
               .pairs = kernel::TilePairs::all,
               .groups = &pairs.contacts.groups(),
               .laws = scene.laws.data(),
               .constants = &pairs.constants,
               .slots = nullptr,
               .sums = nullptr,
               .profile = nullptr},
              of_tiles[tile]);
  };
  for (std::size_t tile = 0; tile < of_tiles.size(); ++tile)
    if (!share_)
      evaluate(tile);
    else if (share_->owners.is_own(tile))
      share_->failure.guard([&] { evaluate(tile); });
  return total(of_tiles, scene.particles.dimension(), true).load;
}

DisplacedLoads::Total DisplacedLoads::total(const std::vector<scree_load>& of_tiles, int dimension,
                                            bool asking) const {
  Total total = {.load = {}, .asking = asking};
  RankSums sums(share_ ? &share_->ranks : nullptr);
  for (int k = 0; k < dimension; ++k)
    sums.sum(total.load.force[k], of_tiles, [&](const scree_load& of_tile) { return of_tile.force[k]; });
  sums.total(total.asking);
  sums.close();
  return total;
}

void DisplacedLoads::finish(int dimension) {
  if (!share_) return;
  const std::vector<scree_load> nothing(share_->owners.tiles(), scree_load{});
  while (total(nothing, dimension, false).asking > 0) {
  }
}

DisplacedLoads::PlanePairs& DisplacedLoads::pairs_of(const Scene& scene, std::size_t plane) {
  while (pairs_.size() <= plane) pairs_.emplace_back();
  PlanePairs& pairs = pairs_[plane];
  if (pairs.revision != scene.contacts.revision()) take(scene, plane, pairs);
  return pairs;
}

void DisplacedLoads::take(const Scene& scene, std::size_t plane, PlanePairs& pairs) const {
  pairs.revision = scene.contacts.revision();
  std::vector<Contacts::Kind> kinds;
  for (const PairGroup& group : scene.contacts.groups())
    if (group.planes && !group.surfaces) kinds.push_back({group.law, true, group.history_width});
  pairs.contacts = Contacts(kinds, BodyTiles(scene.particles.size()));
  pairs.rows.assign(kinds.size(), {});
  std::size_t next = 0;
  for (const PairGroup& all : scene.contacts.groups()) {
    if (!all.planes || all.surfaces) continue;
    std::vector<PairColumns::Move>& rows = pairs.rows[next];
    std::vector<PlanePair> of_plane;
    all.each_pair([&](std::size_t q) {
      if (scene.contacts.b[q] != plane) return;
      rows.push_back({std::uint32_t(q - all.begin), 0});
      of_plane.push_back({scene.contacts.a[q], std::uint32_t(plane)});
    });
    pairs.contacts.append(next, of_plane);
    const PairGroup& taken = pairs.contacts.groups()[next++];
    std::size_t row = 0;
    taken.each_pair([&](std::size_t q) { rows[row++].to = std::uint32_t(q - taken.begin); });
  }
  ThreadPool alone(1);
  pairs.constants.update(pairs.contacts, scene.particles, reads_of(scene.laws), false, alone);
}

}  // namespace scree
