#include "evaluate.hpp"

#include "../instruction_levels.hpp"
#include "gather.hpp"
#include "kinematics.hpp"
#include "scatter.hpp"
#include "sums.hpp"

#include <type_traits>

#include <scree/contact_batch.hpp>

namespace scree::kernel {

namespace {

// One block of a tile, as its phases see it.
template <class T>
struct BlockJob {
  const TileJob& tile;
  const Tiles::Block& place;
  PairGroup& group;
  const LawInstance& law;
  std::uint32_t count;  // pairs without padding
  // With padding; that it is a multiple saves loops over lanes what would be left over.
  std::uint32_t padded() const { return place.count / SCREE_LANES * SCREE_LANES; }
  const double* radius_sum;

  // Of what is kept for every pair.
  const T* constant(scree_contact_input column) const {
    return tile.constants->terms[column - SCREE_REDUCED_MASS].template column<T>(0) + place.begin;
  }
  // Of the force: the pairs' own, or the block's where they keep none.
  T* force(std::uint32_t k, Block<T>& w) const {
    return tile.scene->pair_forces ? tile.constants->force.template column<T>(k) + place.begin
                                   : w.output[SCREE_FORCE + k];
  }
  bool reads(scree_contact_input column) const { return law.interface.reads & (1u << column); }
  bool arms_to_contact_point() const { return law.interface.arms == SCREE_ARM_CONTACT_POINT; }
};

template <class T>
SCREE_HOT BlockJob<T> block_job(const TileJob& job, std::size_t k) {
  const Tiles::Block& place = job.tiles->blocks()[k];
  PairGroup& group = (*job.groups)[place.group];
  const std::size_t end = std::min(place.begin + place.count, std::max(group.end, place.begin));
  return {job,
          place,
          group,
          job.laws[group.law],
          std::uint32_t(end - place.begin),
          job.constants->radius_sum.data() + place.begin};
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void gather(const BlockJob<T>& b, Block<T>& w) {
  for (std::uint32_t i = 0; i < b.padded(); i += 4)
    gather_four<D, spin, planes>(*b.tile.scene, b.place.begin + i, i, w);
  if constexpr (planes) part_lanes(b.count, b.padded(), w);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void resolve(const BlockJob<T>& b, Block<T>& w) {
  const std::uint32_t padded = b.padded();
  const bool to_contact_point = b.arms_to_contact_point();
  resolve_overlaps<D, planes>(b.radius_sum, padded, w);
  if (b.reads(SCREE_CONTACT_RADIUS)) resolve_contact_radii(b.constant(SCREE_EFFECTIVE_RADIUS), padded, w);
  const double step = b.tile.scene->step;
  const auto motion = [&]<bool increments>() SCREE_INLINE_LAMBDA {
    const bool near =
        resolve_motion<D, spin, planes, increments>(to_contact_point, b.radius_sum, step, padded, w) > 0;
    w.batch.input[SCREE_ONSET_WEIGHT] = near ? w.input[SCREE_ONSET_WEIGHT] : w.ones;
    if (near)
      resolve_onsets<D, spin, planes, increments>(to_contact_point, b.radius_sum, step, b.law.touching,
                                                  b.law.parting, padded, w);
  };
  if (b.reads(SCREE_TANGENTIAL_INCREMENT))
    motion.template operator()<true>();
  else if (b.reads(SCREE_RELATIVE_VELOCITY) || b.reads(SCREE_ONSET_WEIGHT))
    motion.template operator()<false>();
}

// What is the same for all blocks of a tile.
template <class T>
SCREE_HOT void begin_batch(const Scene& scene, Block<T>& w) {
  w.batch = {};
  w.batch.struct_size = sizeof(w.batch);
  w.batch.step = scene.step;
  for (std::uint32_t k = 0; k < SCREE_REDUCED_MASS; ++k) w.batch.input[k] = w.input[k];
  std::fill(std::begin(w.ones), std::end(w.ones), T(1));
  const std::uint32_t outputs = scene.audit ? SCREE_CONTACT_OUTPUT_COUNT : SCREE_ELASTIC_NORMAL;
  for (std::uint32_t k = 0; k < outputs; ++k) w.batch.output[k] = w.output[k];
}

template <int D, class T>
SCREE_HOT void call_law(const BlockJob<T>& b, Block<T>& w) {
  ContactBatch<T>& batch = w.batch;
  batch.count = b.padded();
  for (const scree_contact_input k : {SCREE_REDUCED_MASS, SCREE_REDUCED_MASS_ROOT, SCREE_EFFECTIVE_RADIUS})
    if (b.reads(k)) batch.input[k] = b.constant(k);
  for (std::uint32_t k = 0; k < b.group.history_width; ++k)
    batch.history[k] = b.group.history.template column<T>(k) + (b.place.begin - b.group.begin);
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) batch.output[SCREE_FORCE + k] = b.force(k, w);
  if constexpr (std::is_same_v<T, float>)
    b.law.interface.evaluate_single(b.law.storage, &batch);
  else
    b.law.interface.evaluate(b.law.storage, &batch);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT void scatter(const BlockJob<T>& b, Block<T>& w) {
  const T* force[3] = {};
  for (std::uint32_t k = 0; k < std::uint32_t(D); ++k) force[k] = b.force(k, w);
  if constexpr (spin) {
    if (b.law.interface.writes_couple)
      resolve_torques<D, planes, true>(b.arms_to_contact_point(), b.radius_sum, force, b.padded(), w);
    else
      resolve_torques<D, planes, false>(b.arms_to_contact_point(), b.radius_sum, force, b.padded(), w);
  }
  const std::uint32_t* slot_a = b.tile.tiles->slot_a().data() + b.place.begin;
  const std::uint32_t* slot_b = b.tile.tiles->slot_b().data() + b.place.begin;
  for (std::uint32_t i = 0; i < b.padded(); i += 4)
    scatter_four<D, spin>(force, slot_a + i, slot_b + i, i, w, b.tile.slots);
}

template <int D, bool spin, bool planes, class T>
SCREE_HOT ContactSums evaluate_block(const BlockJob<T>& b, Block<T>& w, double& largest_ratio) {
  Laps laps(b.tile.profile);
  gather<D, spin, planes>(b, w);
  laps.lap(Profile::gather);
  resolve<D, spin, planes>(b, w);
  laps.lap(Profile::geometry);
  call_law<D>(b, w);
  laps.lap(Profile::law);
  scatter<D, spin, planes>(b, w);
  largest_ratio = largest_overlap_ratio<planes>(b.radius_sum, b.padded(), w, largest_ratio);
  const ContactSums sums = b.tile.scene->audit ? sum_block(w, b.padded()) : ContactSums();
  laps.lap(Profile::reduce);
  return sums;
}

// Asks for the bodies that a block soon to come looks at first.
template <int D, bool spin>
SCREE_HOT void fetch_ahead(const TileJob& job, std::size_t block) {
  constexpr std::size_t ahead = 2, cache_line = 64 / sizeof(double);
  if (block + ahead >= job.tiles->blocks().size()) return;
  const Tiles::Block& next = job.tiles->blocks()[block + ahead];
  for (std::size_t k = next.first_visit; k < next.last_visit; ++k) {
    const double* record = record_of<D, spin>(job.scene->records, job.tiles->visits()[k]);
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
  Block<T> work;
  begin_batch(*job.scene, work);
  double largest_ratio = job.scene->deepest;
  for (std::size_t k = tile.first_block; k < tile.last_block; ++k) {
    const BlockJob<T> block = block_job<T>(job, k);
    fetch_ahead<D, spin>(job, k);
    job.sums[k] = block.group.planes ? evaluate_block<D, spin, true>(block, work, largest_ratio)
                                     : evaluate_block<D, spin, false>(block, work, largest_ratio);
    job.sums[k].max_overlap_ratio = largest_ratio;
  }
}

// The same code once more for each instruction level. No contraction and no reassociation: the same bits.
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
