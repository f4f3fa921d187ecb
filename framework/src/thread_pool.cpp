#include <scree/thread_pool.hpp>

namespace scree {

namespace {

// Steps follow each other within microseconds, so a waiting thread spins before it sleeps, for some 400 µs:
// waking a sleeper takes a virtual machine 100 µs. Not longer, for on a busy machine the one it waits for may
// not run.
constexpr int spins_before_sleep = 8000;

template <class Done>
void spin_until(const Done& done) {
  for (int k = 0; k < spins_before_sleep && !done(); ++k) {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
}

}  // namespace

ThreadPool::ThreadPool(unsigned threads) {
  for (unsigned worker = 1; worker < threads; ++worker)
    workers_.emplace_back([this, worker] { work(worker); });
}

ThreadPool::~ThreadPool() {
  stop_.store(true, std::memory_order_relaxed);
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::start(Call call, const void* task) {
  call_ = call;
  task_ = task;
  unfinished_.store(std::uint32_t(workers_.size()), std::memory_order_relaxed);
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  call(task, 0);
  spin_until([this] { return unfinished_.load(std::memory_order_acquire) == 0; });
  for (std::uint32_t left; (left = unfinished_.load(std::memory_order_acquire)) != 0;)
    unfinished_.wait(left, std::memory_order_acquire);
}

void ThreadPool::work(unsigned worker) {
  for (std::uint32_t seen = 0;; ++seen) {
    spin_until([&] { return generation_.load(std::memory_order_acquire) != seen; });
    generation_.wait(seen, std::memory_order_acquire);
    if (stop_.load(std::memory_order_relaxed)) return;
    call_(task_, worker);
    if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
  }
}

}  // namespace scree
