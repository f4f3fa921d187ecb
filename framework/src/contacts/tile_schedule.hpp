#pragma once

#include "contacts/halo.hpp"
#include "contacts/kernel/tiles.hpp"

#include <atomic>
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

  // The same for the tiles of one rank: those that read no bodies of other ranks while the records of such
  // bodies come, and parts that no pair of other ranks loads while their loads come.
  template <class EvaluateTile, class FinishPart>
  void run_share(const kernel::Tiles& tiles, const std::vector<std::uint32_t>& own, Halo& halo,
                 Particles& particles, ThreadPool& threads, const EvaluateTile& evaluate_tile,
                 const FinishPart& finish_part) {
    std::vector<std::uint32_t> inner, outer, loaded;
    for (const std::uint32_t tile : own) {
      (halo.reads_others(tile) ? outer : inner).push_back(tile);
      if (halo.is_loaded_by_others(tile)) loaded.push_back(tile);
    }
    reset_pending(tiles);
    for (const std::uint32_t tile : loaded) pending_[tile].fetch_add(1, std::memory_order_relaxed);
    const auto evaluate = [&](const std::vector<std::uint32_t>& some) {
      threads.each(some.size(), [&](std::size_t k, unsigned worker) {
        evaluate_and_finish(tiles, some[k], worker, evaluate_tile, finish_part);
      });
    };
    const auto finish_remaining = [&] {
      threads.each(own.size(), [&](std::size_t k, unsigned worker) {
        finish_if_ready(tiles, own[k], worker, finish_part);
      });
    };
    halo.begin_records(particles);
    evaluate(inner);
    halo.finish_records(particles);
    evaluate(outer);
    halo.begin_loads(particles);
    finish_remaining();
    halo.finish_loads();
    for (const std::uint32_t tile : loaded) pending_[tile].fetch_sub(1, std::memory_order_relaxed);
    finish_remaining();
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
