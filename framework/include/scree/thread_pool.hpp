#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

namespace scree {

// Worker threads for parallel loops. With one thread everything runs in the caller and no thread is started.
class ThreadPool {
 public:
  // Where fewer threads can be started than asked for, as under a limit of processes.
  enum class IfTooFew { refuse, use_fewer };

  // threads: number including the caller. Throws Error if they cannot be started and fewer are refused.
  explicit ThreadPool(unsigned threads, IfTooFew if_too_few = IfTooFew::refuse);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned size() const { return unsigned(workers_.size()) + 1; }

  // Calls task(item, worker) once for each item 0 ... count − 1 and returns when all are done. A worker first
  // takes its own contiguous share, the same in each call, so that the data may still be in its cache; then
  // it steals items that other workers have not started, so that a descheduled worker does not delay the
  // loop. The first exception of a task is rethrown here; with several threads, after the remaining items are
  // done.
  template <class Task>
  void each(std::size_t count, const Task& task) {
    if (workers_.empty()) {
      for (std::size_t item = 0; item < count; ++item) task(item, 0u);
      return;
    }
    distribute(
        count,
        [](const void* t, std::size_t item, unsigned worker) {
          (*static_cast<const Task*>(t))(item, worker);
        },
        &task);
  }

  // Calls task(item, worker) for the items 0 ... count − 1, which are started in this order: for long items
  // of which the first are wanted if the loop ends early. After an exception no further item is started.
  template <class Task>
  void each_in_order(std::size_t count, const Task& task) {
    std::atomic<std::size_t> next = 0;
    each(size(), [&](std::size_t, unsigned worker) {
      for (std::size_t item; (item = next++) < count;) try {
          task(item, worker);
        } catch (...) {
          next = count;
          throw;
        }
    });
  }

 private:
  using Call = void (*)(const void*, std::size_t, unsigned);
  void distribute(std::size_t count, Call call, const void* task);
  void wait_for_work(unsigned worker);
  void stop();
  void work(std::uint64_t round, unsigned worker);
  bool claim(std::size_t item, std::uint64_t round);
  void run_item(std::size_t item, unsigned worker) noexcept;

  std::vector<std::thread> workers_;
  Call call_ = nullptr;
  const void* task_ = nullptr;
  std::size_t count_ = 0, capacity_ = 0;
  std::unique_ptr<std::atomic<std::uint64_t>[]> claimed_;  // round in which each item was last claimed
  // Apart: workers that begin or end a round write `active_` while others read the rest.
  alignas(64) std::atomic<std::uint64_t> round_ = 0;   // number of rounds; workers wait for the next
  std::atomic<std::uint64_t> open_ = 0;                // the current round, 0 between rounds
  alignas(64) std::atomic<std::uint64_t> active_ = 0;  // workers inside a round, without the caller
  alignas(64) std::atomic<bool> stop_ = false;
  std::atomic<bool> failed_ = false;
  std::exception_ptr error_;  // of the round, set by the thread that set failed_
};

}  // namespace scree
