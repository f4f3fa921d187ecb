#pragma once

#include "contacts/halo.hpp"
#include "contacts/kernel/evaluate.hpp"
#include "contacts/kernel/tiles.hpp"
#include "contacts/share_order.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>

#include <scree/thread_pool.hpp>

namespace scree {

// Distributes the evaluation of tiles and the finishing of their parts over threads. The schedule depends on
// the number of threads, the results do not.
class TileSchedule {
 public:
  // Calls evaluate_tile(tile, worker) for all tiles, and finish_part(part, worker) for each part of their
  // bodies after all tiles that read or load these bodies have been evaluated.
  template <class EvaluateTile, class FinishPart>
  void run(const kernel::Tiles& tiles, ThreadPool& threads, const EvaluateTile& evaluate_tile,
           const FinishPart& finish_part) {
    const std::size_t count = tiles.tiles().size();
    if (threads.size() == 1) {
      run_in_order(tiles, evaluate_tile, finish_part);
    } else if (count < tiles_per_thread * threads.size()) {
      threads.each(count, evaluate_tile);
      threads.each(tiles.bodies().parts(), finish_part);
    } else {
      run_as_ready(tiles, threads, evaluate_tile, finish_part);
    }
  }

  // The same for the tiles of one rank; evaluate(tile, worker, pairs). While records of bodies of other ranks
  // come, it evaluates what reads none of them, and while their loads come, tiles that it has kept for that.
  // Returns the time for which it has not waited (s).
  template <class Evaluate, class FinishPart>
  double run_share(const kernel::Tiles& tiles, const ShareOrder& order, Halo& halo, Particles& particles,
                   ThreadPool& threads, const Evaluate& evaluate, const FinishPart& finish_part) {
    using kernel::TilePairs;
    reset_pending(tiles);
    for (const std::uint32_t tile : order.loaded) pending_[tile].fetch_add(1, std::memory_order_relaxed);
    double busy = 0;
    const auto each = [&](const std::vector<std::uint32_t>& some, const auto& work) {
      const auto start = std::chrono::steady_clock::now();
      threads.each(some.size(), [&](std::size_t k, unsigned worker) { work(some[k], worker); });
      busy += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const auto all_of_tile = [&](std::uint32_t tile, unsigned worker) {
      evaluate(tile, worker, TilePairs::all);
      after_evaluation(tiles, tile, worker, finish_part);
    };
    halo.begin_records(particles);
    each(order.before_records, all_of_tile);
    each(order.split,
         [&](std::uint32_t tile, unsigned worker) { evaluate(tile, worker, TilePairs::inside); });
    halo.finish_records(particles);
    each(order.split, [&](std::uint32_t tile, unsigned worker) {
      evaluate(tile, worker, TilePairs::crossing);
      after_evaluation(tiles, tile, worker, finish_part);
    });
    each(order.reading, all_of_tile);
    halo.begin_loads(particles);
    each(order.kept, all_of_tile);
    halo.finish_loads(particles);
    for (const std::uint32_t tile : order.loaded) pending_[tile].fetch_sub(1, std::memory_order_relaxed);
    each(order.after_loads, all_of_tile);
    each(order.last_first,
         [&](std::uint32_t tile, unsigned worker) { finish_if_ready(tiles, tile, worker, finish_part); });
    return busy;
  }

 private:
  // With fewer tiles per thread, the first threads would also finish parts while the last ones wait for them.
  static constexpr std::size_t tiles_per_thread = 8;
  static constexpr std::uint32_t finished = ~0u;

  // The tile of the lower place evaluates a pair, so that no later tile reads the bodies of this one.
  template <class EvaluateTile, class FinishPart>
  static void run_in_order(const kernel::Tiles& tiles, const EvaluateTile& evaluate_tile,
                           const FinishPart& finish_part) {
    for (std::size_t tile = 0; tile < tiles.tiles().size(); ++tile) {
      evaluate_tile(tile, 0);
      tiles.bodies().each_part(tile, [&](std::size_t part) { finish_part(part, 0); });
    }
  }

  // Finishes a tile directly after its evaluation if no other tile still needs its bodies, while these are in
  // the cache of the thread; the remaining tiles in a second loop.
  template <class EvaluateTile, class FinishPart>
  void run_as_ready(const kernel::Tiles& tiles, ThreadPool& threads, const EvaluateTile& evaluate_tile,
                    const FinishPart& finish_part) {
    const std::size_t count = tiles.tiles().size();
    reset_pending(tiles);
    threads.each(count, [&](std::size_t tile, unsigned worker) {
      evaluate_and_finish(tiles, tile, worker, evaluate_tile, finish_part);
    });
    threads.each(
        count, [&](std::size_t tile, unsigned worker) { finish_if_ready(tiles, tile, worker, finish_part); });
  }

  template <class EvaluateTile, class FinishPart>
  void evaluate_and_finish(const kernel::Tiles& tiles, std::size_t tile, unsigned worker,
                           const EvaluateTile& evaluate_tile, const FinishPart& finish_part) {
    evaluate_tile(tile, worker);
    after_evaluation(tiles, tile, worker, finish_part);
  }

  template <class FinishPart>
  void after_evaluation(const kernel::Tiles& tiles, std::size_t tile, unsigned worker,
                        const FinishPart& finish_part) {
    for (const std::uint32_t reached : tiles.tiles()[tile].reached)
      pending_[reached].fetch_sub(1, std::memory_order_acq_rel);
    finish_if_ready(tiles, tile, worker, finish_part);
  }

  template <class FinishPart>
  void finish_if_ready(const kernel::Tiles& tiles, std::size_t tile, unsigned worker,
                       const FinishPart& finish_part) {
    std::uint32_t none = 0;
    if (pending_[tile].compare_exchange_strong(none, finished, std::memory_order_acq_rel))
      tiles.bodies().each_part(tile, [&](std::size_t part) { finish_part(part, worker); });
  }

  void reset_pending(const kernel::Tiles& tiles) {
    const std::size_t count = tiles.tiles().size();
    if (count_ != count) pending_ = std::make_unique<std::atomic<std::uint32_t>[]>(count_ = count);
    for (std::size_t tile = 0; tile < count; ++tile)
      pending_[tile].store(tiles.tiles()[tile].reached_by, std::memory_order_relaxed);
  }

  // For each tile: number of tiles that reach it and are not yet evaluated; `finished` once a thread has
  // claimed it.
  std::unique_ptr<std::atomic<std::uint32_t>[]> pending_;
  std::size_t count_ = 0;
};

}  // namespace scree
