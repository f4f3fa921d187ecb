#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace scree {

// Threads that wait for work. With one thread everything runs in the caller and no thread is started.
class ThreadPool {
 public:
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned size() const { return unsigned(workers_.size()) + 1; }

  // Calls task(worker) once for each worker 0 ... size() − 1 and returns when all are done.
  // The task must not throw.
  template <class Task>
  void run(const Task& task) {
    if (workers_.empty()) return task(0u);
    start([](const void* t, unsigned worker) { (*static_cast<const Task*>(t))(worker); }, &task);
  }

  // The part of [0, count) that belongs to a worker; parts are contiguous and in order.
  struct Part {
    std::size_t begin, end;
  };
  Part part(std::size_t count, unsigned worker) const {
    return {count * worker / size(), count * (worker + 1) / size()};
  }

 private:
  using Call = void (*)(const void*, unsigned);
  void start(Call call, const void* task);
  void work(unsigned worker);

  std::vector<std::thread> workers_;
  Call call_ = nullptr;
  const void* task_ = nullptr;
  std::atomic<std::uint32_t> generation_ = 0;
  std::atomic<std::uint32_t> unfinished_ = 0;
  std::atomic<bool> stop_ = false;
};

}  // namespace scree
