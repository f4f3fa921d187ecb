#include "contacts/kernel/evaluate.hpp"

#include "contacts/kernel/gather.hpp"
#include "contacts/kernel/kinematics.hpp"
#include "contacts/kernel/orientations.hpp"
#include "contacts/kernel/scatter.hpp"
#include "contacts/kernel/sums.hpp"
#include "plugins/instruction_levels.hpp"

#include <cassert>
#include <type_traits>

#include <scree/plugin/contact_batch.hpp>

namespace scree::kernel {

namespace {

// One block of a tile: the input of its phases.
template <class T>
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
  const T* constant(scree_contact_input column) const {
    return tile.constants->terms[column - SCREE_REDUCED_MASS].template column<T>(0) + pairs.begin;
  }
  // Where forces are written: the pairs' own column, or the block's if pair forces are not stored.
  T* force(std::uint32_t k, BlockColumns<T>& block) const {
    return tile.input->pair_forces ? tile.constants->force.template column<T>(k) + pairs.begin
                                   : block.output[SCREE_FORCE + k];
  }
  bool reads(scree_contact_input column) const { return law.interface.reads & (1u << column); }
  bool arms_to_contact_point() const { return law.interface.arms == SCREE_ARM_CONTACT_POINT; }
};

template <class T>
SCREE_HOT BlockTask<T> block_task(const TileJob& job, std::size_t k) {
  const Tiles::PairBlock& pairs = job.tiles->blocks()[k];
  PairGroup& group = (*job.groups)[pairs.group];
  const std::size_t end = std::min(pairs.begin + pairs.count, std::max(group.end, pairs.begin));
  return {job,
          pairs,
          group,
          job.laws[group.law],
          std::uint32_t(end - pairs.begin),
          job.constants->radius_sum.data() + pairs.begin};
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void gather(const BlockTask<T>& task, BlockColumns<T>& block) {
  for (std::uint32_t i = 0; i < task.padded(); i += 4)
    gather_four<D, spin, planes>(*task.tile.input, task.pairs.begin + i, i, block);
  if constexpr (planes) separate_padding(task.count, task.padded(), block);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void resolve(const BlockTask<T>& task, BlockColumns<T>& block) {
  const std::uint32_t padded = task.padded();
  const bool to_contact_point = task.arms_to_contact_point();
  resolve_overlaps<D, planes>(task.radius_sum, padded, block);
  if (task.reads(SCREE_CONTACT_RADIUS))
    resolve_contact_radii(task.constant(SCREE_EFFECTIVE_RADIUS), padded, block);
  const double step = task.tile.input->step;
  const auto motion = [&]<bool increments>() SCREE_INLINE_LAMBDA {
    const bool near = resolve_motion<D, spin, planes, increments>(to_contact_point, task.radius_sum, step,
                                                                  padded, block) > 0;
    block.batch.input[SCREE_ONSET_WEIGHT] = near ? block.input[SCREE_ONSET_WEIGHT] : block.ones;
    if (near)
      resolve_onsets<D, spin, planes, increments>(to_contact_point, task.radius_sum, step, task.law.touching,
                                                  task.law.parting, padded, block);
  };
  if (task.reads(SCREE_TANGENTIAL_INCREMENT))
    motion.template operator()<true>();
  else if (task.reads(SCREE_RELATIVE_VELOCITY) || task.reads(SCREE_ONSET_WEIGHT))
    motion.template operator()<false>();
}

// Sets the members of the batch that are the same for all blocks of a tile.
template <class T>
SCREE_HOT void begin_batch(const EvaluationInput& input, BlockColumns<T>& block) {
  block.batch = {};
  block.batch.struct_size = sizeof(block.batch);
  block.batch.step = input.step;
  for (std::uint32_t k = 0; k < SCREE_REDUCED_MASS; ++k) block.batch.input[k] = block.input[k];
  std::fill(std::begin(block.ones), std::end(block.ones), T(1));
  const std::uint32_t outputs = input.audit ? SCREE_CONTACT_OUTPUT_COUNT : SCREE_ELASTIC_NORMAL;
  for (std::uint32_t k = 0; k < outputs; ++k) block.batch.output[k] = block.output[k];
}

template <int D, class T>
SCREE_HOT void call_law(const BlockTask<T>& task, BlockColumns<T>& block) {
  ContactBatch<T>& batch = block.batch;
  batch.count = task.padded();
  for (const scree_contact_input k : {SCREE_REDUCED_MASS, SCREE_REDUCED_MASS_ROOT, SCREE_EFFECTIVE_RADIUS})
    if (task.reads(k)) batch.input[k] = task.constant(k);
  for (std::uint32_t k = 0; k < task.group.history_width; ++k)
    batch.history[k] = task.group.history.template column<T>(k) + (task.pairs.begin - task.group.begin);
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) batch.output[SCREE_FORCE + k] = task.force(k, block);
  if constexpr (std::is_same_v<T, float>)
    task.law.interface.evaluate_single(task.law.storage, &batch);
  else
    task.law.interface.evaluate(task.law.storage, &batch);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void scatter(const BlockTask<T>& task, BlockColumns<T>& block) {
  const T* force[3] = {};
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) force[k] = task.force(k, block);
  if constexpr (spin) {
    if (task.law.interface.writes_couple)
      resolve_torques<D, planes, true>(task.arms_to_contact_point(), task.radius_sum, force, task.padded(),
                                       block);
    else
      resolve_torques<D, planes, false>(task.arms_to_contact_point(), task.radius_sum, force, task.padded(),
                                        block);
  }
  const std::uint32_t* slot_a = task.tile.tiles->slot_a().data() + task.pairs.begin;
  const std::uint32_t* slot_b = task.tile.tiles->slot_b().data() + task.pairs.begin;
  for (std::uint32_t i = 0; i < task.padded(); i += 4)
    scatter_four<D, spin>(force, slot_a + i, slot_b + i, i, block, task.tile.slots);
}

// Preconditions of the loops over the pairs of a block.
template <class T>
void assert_layout([[maybe_unused]] const BlockTask<T>& task) {
  assert(task.pairs.count <= block_size && task.pairs.count % SCREE_LANES == 0);
  assert(task.pairs.begin >= task.group.begin && (task.pairs.begin - task.group.begin) % SCREE_LANES == 0);
  assert(task.group.history_width == task.law.interface.history_width);
  assert(task.group.history_width == 0 || task.group.history.width() == task.group.history_width);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT ContactSums evaluate_block(const BlockTask<T>& task, BlockColumns<T>& block,
                                     double& largest_ratio) {
  assert_layout(task);
  Laps laps(task.tile.profile);
  gather<D, spin, planes>(task, block);
  if (reads_orientations(task.law.interface))
    gather_orientations<planes>(*task.tile.input, task.pairs.begin, task.padded(), block);
  laps.lap(Profile::gather);
  resolve<D, spin, planes>(task, block);
  laps.lap(Profile::geometry);
  call_law<D>(task, block);
  laps.lap(Profile::law);
  scatter<D, spin, planes>(task, block);
  largest_ratio = largest_overlap_ratio<planes>(task.radius_sum, task.padded(), block, largest_ratio);
  const ContactSums sums = task.tile.input->audit ? sum_block(block, task.padded()) : ContactSums();
  laps.lap(Profile::reduce);
  return sums;
}

// Prefetches the bodies that the block after the next is the first to read.
template <int D, bool spin>
SCREE_HOT void prefetch_bodies(const TileJob& job, std::size_t block) {
  constexpr std::size_t ahead = 2, cache_line = 64 / sizeof(double);
  if (block + ahead >= job.tiles->blocks().size()) return;
  const Tiles::PairBlock& next = job.tiles->blocks()[block + ahead];
  for (std::size_t k = next.first_visit; k < next.last_visit; ++k) {
    const double* record = record_of<D, spin>(job.input->records, job.tiles->visits()[k]);
    for (std::size_t part = 0; part < record::width(D, spin); part += cache_line)
      __builtin_prefetch(record + part);
    __builtin_prefetch(job.slots + record::load_width(D, spin) * job.tiles->visits()[k], 1);
  }
}

template <int D, bool spin, class T>
SCREE_HOT void evaluate_tile(const TileJob& job) {
  constexpr std::size_t width = record::load_width(D, spin);
  const Tiles::Tile& tile = job.tiles->tiles()[job.tile];
  const std::size_t planes_and_padding =
      (job.tile + 1 < job.tiles->tiles().size() ? job.tiles->tiles()[job.tile + 1].first_foreign
                                                : job.tiles->slots());
  std::fill(job.slots + width * tile.first_foreign, job.slots + width * planes_and_padding, 0.0);
  BlockColumns<T> work;
  begin_batch(*job.input, work);
  double largest_ratio = job.input->max_overlap_ratio;
  for (std::size_t k = tile.first_block; k < tile.last_block; ++k) {
    const BlockTask<T> task = block_task<T>(job, k);
    prefetch_bodies<D, spin>(job, k);
    job.sums[k] = task.group.planes ? evaluate_block<D, spin, true>(task, work, largest_ratio)
                                    : evaluate_block<D, spin, false>(task, work, largest_ratio);
    job.sums[k].max_overlap_ratio = largest_ratio;
  }
}

// The same code compiled for each instruction level. Without contraction and reassociation all have the same
// bits.
#if SCREE_SEVERAL_LEVELS
#define SCREE_LEVELS(X)                \
  X(baseline, )                        \
  X(v3, gnu::target("arch=x86-64-v3")) \
  X(v4, gnu::target("arch=x86-64-v4,prefer-vector-width=512"))
#else
#define SCREE_LEVELS(X) X(baseline, )
#endif
#define SCREE_LEVEL_FUNCTION(level, ...)                                              \
  template <int D, bool spin, class T>                                                \
  [[gnu::flatten __VA_OPT__(, ) __VA_ARGS__]] void tile_##level(const TileJob& job) { \
    evaluate_tile<D, spin, T>(job);                                                   \
  }
SCREE_LEVELS(SCREE_LEVEL_FUNCTION)

template <int D, bool spin, class T>
EvaluateTile best_level() {
  const std::string level = instruction_levels().front();
#if SCREE_SEVERAL_LEVELS
  if (level == "x86-64-v4") return &tile_v4<D, spin, T>;
  if (level == "x86-64-v3") return &tile_v3<D, spin, T>;
#endif
  return &tile_baseline<D, spin, T>;
}

template <class Use>
void specialise(const Forces::Features& f, const Use& use) {
  if (f.dimension == 2)
    f.spin ? use.template operator()<2, true>() : use.template operator()<2, false>();
  else
    f.spin ? use.template operator()<3, true>() : use.template operator()<3, false>();
}

}  // namespace

EvaluateTile tile_evaluation(const Forces::Features& features) {
  EvaluateTile evaluate = nullptr;
  specialise(features, [&]<int D, bool spin>() {
    evaluate =
        features.precision == Precision::mixed ? best_level<D, spin, float>() : best_level<D, spin, double>();
  });
  return evaluate;
}

}  // namespace scree::kernel
