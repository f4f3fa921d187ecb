#include "contacts/kernel/plane_load.hpp"

#include "contacts/kernel/block_task.hpp"
#include "contacts/kernel/levels.hpp"

namespace scree::kernel {

namespace {

// Sums in a fixed order, for all instruction levels.
struct LaneSums {
  double lanes[3][SCREE_LANES] = {};

  SCREE_HOT void add(int k, const double* column, std::uint32_t padded) {
    for (std::uint32_t i = 0; i < padded; i += SCREE_LANES)
      for (std::uint32_t lane = 0; lane < SCREE_LANES; ++lane) lanes[k][lane] += column[i + lane];
  }
  SCREE_HOT double total(int k) const {
    double sum = 0;
    for (const double lane : lanes[k]) sum += lane;
    return sum;
  }
};

template <int D, bool spin>
SCREE_HOT void evaluate_plane_load(const TileJob& job, scree_load& load) {
  BlockColumns work;
  begin_batch(*job.input, work);
  LaneSums on_bodies;
  for (std::uint32_t g = 0; g < job.groups->size(); ++g) {
    const PairGroup& group = (*job.groups)[g];
    const PairRun& run = group.runs[job.tile];
    for (std::size_t begin = run.begin; begin < run.end; begin += block_size) {
      const auto count = std::uint32_t(std::min<std::size_t>(block_size, run.end - begin));
      const Tiles::PairBlock pairs = {g, begin, std::uint32_t(padded_to_lanes(count)), count};
      const BlockTask task = block_task(job, pairs);
      assert_layout(task);
      gather<D, spin, Partner::plane>(task, work, [](std::uint32_t) {});
      if (reads_placement(task.law.interface))
        gather_placement<Partner::plane>(task.to_place<Partner::plane>(), task.law.interface, work);
      resolve<D, spin, Partner::plane>(task, work);
      call_law<D>(task, work);
      for (int k = 0; k < D; ++k) on_bodies.add(k, work.output[SCREE_FORCE + k], task.padded());
    }
  }
  load = {};
  for (int k = 0; k < D; ++k) load.force[k] = -on_bodies.total(k);
}

template <int D, bool spin>
SCREE_AT_KERNEL_LEVEL void plane_load(const TileJob& job, scree_load& load) {
  evaluate_plane_load<D, spin>(job, load);
}

}  // namespace

template <>
EvaluatePlaneLoad plane_load_evaluation_at<SCREE_KERNEL_LEVEL>(const Forces::Features& features) {
  EvaluatePlaneLoad evaluate = nullptr;
  specialise(features, [&]<int D, bool spin>() { evaluate = &plane_load<D, spin>; });
  return evaluate;
}

}  // namespace scree::kernel
