#pragma once

#include "contacts/kernel/evaluate.hpp"
#include "contacts/kernel/gather.hpp"
#include "contacts/kernel/kinematics.hpp"
#include "contacts/kernel/placement.hpp"

#include <cassert>

// The phases of a block of pairs up to the forces: gather -> geometry -> law.

namespace scree::kernel {

// One block of a tile: the input of its phases.
struct BlockTask {
  const TileJob& tile;
  const Tiles::PairBlock& pairs;
  PairGroup& group;
  const LawInstance& law;
  std::uint32_t count;  // pairs without padding
  // With padding; an explicit multiple of SCREE_LANES, so that loops over lanes need no remainder.
  std::uint32_t padded() const { return pairs.count / SCREE_LANES * SCREE_LANES; }
  const double* radius_sum;

  // A constant of the pairs.
  const double* constant(scree_contact_input column) const {
    return tile.constants->terms[column - SCREE_REDUCED_MASS].column(0) + pairs.begin;
  }
  // Where forces are written: the pairs' own column, or the block's if pair forces are not stored.
  double* force(std::uint32_t k, BlockColumns& block) const {
    return tile.input->pair_forces ? tile.constants->force.column(k) + pairs.begin
                                   : block.output[SCREE_FORCE + k];
  }
  bool reads(scree_contact_input column) const { return law.interface.reads & (1u << column); }
  // Of its first pair with a surface.
  std::size_t surface_row() const {
    return tile.input->surfaces->first_row(pairs.group) + pairs.begin - group.begin;
  }
  template <Partner partner>
  PairsToPlace to_place() const {
    return {*tile.input, pairs.begin, padded(), partner == Partner::surface ? surface_row() : 0};
  }
  bool arms_to_contact_point() const { return law.interface.arms == SCREE_ARM_CONTACT_POINT; }
};

SCREE_HOT BlockTask block_task(const TileJob& job, const Tiles::PairBlock& pairs) {
  PairGroup& group = (*job.groups)[pairs.group];
  return {
      job, pairs, group, job.laws[group.law], pairs.pairs, job.constants->radius_sum.data() + pairs.begin};
}

// Calls prefetch(i) before every four pairs.
template <int D, bool spin, Partner partner, class Prefetch>
SCREE_HOT void gather(const BlockTask& task, BlockColumns& block, const Prefetch& prefetch) {
  const std::size_t row = partner == Partner::surface ? task.surface_row() : 0;
  for (std::uint32_t i = 0; i < task.padded(); i += 4) {
    prefetch(i);
    gather_four<D, spin, partner>(*task.tile.input, task.pairs.begin + i, row + i, i, block);
  }
  if constexpr (is_wall(partner)) separate_padding(task.count, task.padded(), block);
}

template <int D, bool spin, Partner partner>
SCREE_HOT void resolve(const BlockTask& task, BlockColumns& block) {
  constexpr bool planes = is_wall(partner);
  const std::uint32_t padded = task.padded();
  const bool to_contact_point = task.arms_to_contact_point();
  resolve_overlaps<D, planes>(task.radius_sum, padded, block);
  if (task.reads(SCREE_CONTACT_RADIUS))
    resolve_contact_radii(task.constant(SCREE_EFFECTIVE_RADIUS), padded, block);
  const double step = task.tile.input->step, kick = task.tile.input->kick;
  const auto motion = [&]<bool increments>() SCREE_INLINE_LAMBDA {
    const bool near = resolve_motion<D, spin, partner, increments>(to_contact_point, task.radius_sum, step,
                                                                   kick, padded, block) > 0;
    block.batch.input[SCREE_ONSET_WEIGHT] = near ? block.input[SCREE_ONSET_WEIGHT] : block.ones;
    if (near)
      resolve_onsets<D, spin, partner, increments>(to_contact_point, task.radius_sum, step, kick,
                                                   task.law.touching, task.law.parting, padded, block);
  };
  if (task.reads(SCREE_TANGENTIAL_INCREMENT))
    motion.template operator()<true>();
  else if (task.reads(SCREE_RELATIVE_VELOCITY) || task.reads(SCREE_ONSET_WEIGHT))
    motion.template operator()<false>();
}

// Sets the members of the batch that are the same for all blocks of a tile.
SCREE_HOT void begin_batch(const EvaluationInput& input, BlockColumns& block) {
  block.batch = {};
  block.batch.struct_size = sizeof(block.batch);
  block.batch.step = input.step;
  block.batch.kick = input.kick;
  for (std::uint32_t k = 0; k < SCREE_REDUCED_MASS; ++k) block.batch.input[k] = block.input[k];
  std::fill(std::begin(block.ones), std::end(block.ones), 1.0);
  const std::uint32_t outputs = input.audit ? SCREE_CONTACT_OUTPUT_COUNT : SCREE_ELASTIC_NORMAL;
  for (std::uint32_t k = 0; k < outputs; ++k) block.batch.output[k] = block.output[k];
}

template <int D>
SCREE_HOT void call_law(const BlockTask& task, BlockColumns& block) {
  scree_contact_batch& batch = block.batch;
  batch.count = task.padded();
  for (const scree_contact_input k : {SCREE_REDUCED_MASS, SCREE_REDUCED_MASS_ROOT, SCREE_EFFECTIVE_RADIUS})
    if (task.reads(k)) batch.input[k] = task.constant(k);
  for (std::uint32_t k = 0; k < task.group.history_width; ++k)
    batch.history[k] = task.group.history.column(k) + (task.pairs.begin - task.group.begin);
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) batch.output[SCREE_FORCE + k] = task.force(k, block);
  task.law.interface.evaluate(task.law.storage, &batch);
}

// Preconditions of the loops over the pairs of a block.
inline void assert_layout([[maybe_unused]] const BlockTask& task) {
  assert(task.pairs.count <= block_size && task.pairs.count % SCREE_LANES == 0);
  assert(task.pairs.begin >= task.group.begin && (task.pairs.begin - task.group.begin) % SCREE_LANES == 0);
  assert(task.group.history_width == task.law.interface.history_width);
  assert(task.group.history_width == 0 || task.group.history.width() == task.group.history_width);
}

}  // namespace scree::kernel
