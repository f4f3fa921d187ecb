#include "contacts/kernel/evaluate.hpp"

#include "contacts/kernel/block_task.hpp"
#include "contacts/kernel/levels.hpp"
#include "contacts/kernel/prefetch.hpp"
#include "contacts/kernel/scatter.hpp"
#include "contacts/kernel/sums.hpp"

namespace scree::kernel {

namespace {

// In each of them the bodies of the next tile are prefetched once.
constexpr std::size_t phases = 4;

template <int D, bool spin, Partner partner>
SCREE_HOT void scatter(const BlockTask& task, BlockColumns& block) {
  const double* force[3] = {};
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) force[k] = task.force(k, block);
  if constexpr (spin) {
    if (task.law.interface.writes_couple)
      resolve_torques<D, partner, true>(task.arms_to_contact_point(), task.radius_sum, force, task.padded(),
                                        block);
    else
      resolve_torques<D, partner, false>(task.arms_to_contact_point(), task.radius_sum, force, task.padded(),
                                         block);
  }
  const std::uint32_t* slot_a = task.tile.tiles->slot_a().data() + task.pairs.begin;
  const std::uint32_t* slot_b = task.tile.tiles->slot_b().data() + task.pairs.begin;
  for (std::uint32_t i = 0; i < task.padded(); i += 4)
    scatter_four<D, spin>(force, slot_a + i, slot_b + i, i, block, task.tile.slots);
}

template <int D, bool spin, Partner partner>
SCREE_HOT void gather_and_prefetch(const BlockTask& task, BlockColumns& block) {
  if (!task.tile.tiles->exceed_caches()) return gather<D, spin, partner>(task, block, [](std::uint32_t) {});
  const PairsAhead pairs(task);
  gather<D, spin, partner>(task, block, [&](std::uint32_t i) SCREE_INLINE_LAMBDA { pairs.prefetch(i); });
}

template <int D, bool spin, Partner partner>
SCREE_HOT void evaluate_block(const BlockTask& task, BlockColumns& block, BodiesAhead<D, spin>& bodies,
                              ContactSums& sums) {
  constexpr bool planes = is_wall(partner);
  assert_layout(task);
  Laps laps(task.tile.profile);
  bodies.prefetch();
  gather_and_prefetch<D, spin, partner>(task, block);
  if (reads_placement(task.law.interface))
    gather_placement<partner>(task.to_place<partner>(), task.law.interface, block);
  laps.lap(Profile::gather);
  bodies.prefetch();
  resolve<D, spin, partner>(task, block);
  laps.lap(Profile::geometry);
  bodies.prefetch();
  call_law<D>(task, block);
  laps.lap(Profile::law);
  bodies.prefetch();
  scatter<D, spin, partner>(task, block);
  sums.max_overlap_ratio =
      largest_overlap_ratio<planes>(task.radius_sum, task.padded(), block, sums.max_overlap_ratio);
  if (task.tile.input->audit) sums += sum_block(block, task.padded(), task.tile.input->step < 0);
  if constexpr (partner == Partner::surface)
    if (double* const slips = task.tile.input->slips)
      std::copy_n(block.output[SCREE_DISSIPATED_FRICTION], task.count, slips + task.surface_row());
  laps.lap(Profile::reduce);
}

template <int D, bool spin>
SCREE_HOT void evaluate_tile(const TileJob& job) {
  constexpr std::size_t width = record::load_width(D, spin);
  const Tiles::Tile& tile = job.tiles->tiles()[job.tile];
  const bool goes_on = job.pairs == TilePairs::crossing;
  const std::size_t first = goes_on ? tile.first_crossing : tile.first_block;
  const std::size_t last = job.pairs == TilePairs::inside ? tile.first_crossing : tile.last_block;
  if (!goes_on) std::fill(job.slots + width * tile.first_foreign, job.slots + width * tile.last_own, 0.0);
  BlockColumns work;
  begin_batch(*job.input, work);
  BodiesAhead<D, spin> bodies(job, phases * (last - first));
  ContactSums sums;
  sums.max_overlap_ratio = job.input->max_overlap_ratio;
  if (goes_on) sums = job.sums[job.tile];
  for (std::size_t k = first; k < last; ++k) {
    const BlockTask task = block_task(job, job.tiles->blocks()[k]);
    if (!task.group.planes)
      evaluate_block<D, spin, Partner::body>(task, work, bodies, sums);
    else if (!task.group.surfaces)
      evaluate_block<D, spin, Partner::plane>(task, work, bodies, sums);
    else
      evaluate_block<D, spin, Partner::surface>(task, work, bodies, sums);
  }
  job.sums[job.tile] = sums;
}

template <int D, bool spin>
SCREE_AT_KERNEL_LEVEL void tile(const TileJob& job) {
  evaluate_tile<D, spin>(job);
}

}  // namespace

template <>
EvaluateTile tile_evaluation_at<SCREE_KERNEL_LEVEL>(const Forces::Features& features) {
  EvaluateTile evaluate = nullptr;
  specialise(features, [&]<int D, bool spin>() { evaluate = &tile<D, spin>; });
  return evaluate;
}

}  // namespace scree::kernel
