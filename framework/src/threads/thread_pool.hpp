#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

namespace scree {

// Threads that share out work. With one thread everything runs in the caller and no thread is started.
class ThreadPool {
 public:
  // Throws Error if so many cannot be started.
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned size() const { return unsigned(workers_.size()) + 1; }

  // Calls task(item, worker) once for each item 0 ... count − 1 and returns when all are done. A worker takes
  // a contiguous share of its own first, the same each time, so that its cache knows it, and then what others
  // have not begun: one that the machine does not let run holds nobody up. What a task throws first is
  // thrown here, by several threads once the other items are done.
  template <class Task>
  void each(std::size_t count, const Task& task) {
    if (workers_.empty()) {
      for (std::size_t item = 0; item < count; ++item) task(item, 0u);
      return;
    }
    share_out(
        count,
        [](const void* t, std::size_t item, unsigned worker) {
          (*static_cast<const Task*>(t))(item, worker);
        },
        &task);
  }

 private:
  using Call = void (*)(const void*, std::size_t, unsigned);
  void share_out(std::size_t count, Call call, const void* task);
  void wait_for_work(unsigned worker);
  void stop();
  void work(std::uint64_t round, unsigned worker);
  bool claim(std::size_t item, std::uint64_t round);
  void do_item(std::size_t item, unsigned worker) noexcept;

  std::vector<std::thread> workers_;
  Call call_ = nullptr;
  const void* task_ = nullptr;
  std::size_t count_ = 0, room_ = 0;
  std::unique_ptr<std::atomic<std::uint64_t>[]> claimed_;  // the round in which each item was last taken
  std::atomic<std::uint64_t> round_ = 0;                   // counts rounds; workers wait for the next
  std::atomic<std::uint64_t> open_ = 0;                    // the round that is going on, 0 between rounds
  std::atomic<std::uint64_t> active_ = 0;                  // workers inside a round, beside the caller
  std::atomic<bool> stop_ = false;
  std::atomic<bool> failed_ = false;
  std::exception_ptr error_;  // of the round, set by who sets failed_
};

}  // namespace scree
