#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

namespace {

// A waiting thread spins for about 400 µs before it sleeps: steps follow each other within microseconds, and
// waking a thread takes 100 µs in a virtual machine. It does not spin longer, because on a busy machine the
// thread it waits for may be descheduled.
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

ThreadPool::ThreadPool(unsigned threads, IfTooFew if_too_few) {
  try {
    for (unsigned worker = 1; worker < threads; ++worker)
      workers_.emplace_back([this, worker] { wait_for_work(worker); });
  } catch (const std::system_error&) {
    if (if_too_few == IfTooFew::use_fewer) return;
    const unsigned started = size();
    stop();
    throw Error(
        fmt::format("only {} of {} could be started; use fewer threads", started, counted(threads, "thread")),
        ExitStatus::failure);
  }
}

ThreadPool::~ThreadPool() { stop(); }

void ThreadPool::stop() {
  stop_.store(true);
  round_.fetch_add(1);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

// A round is open while its task may be called. A worker registers as active before it tests whether the
// round is open, and the caller closes the round before it tests for active workers: at least one of the two
// sees the other, so that no worker calls a task after distribute has returned.
void ThreadPool::distribute(std::size_t count, Call call, const void* task) {
  if (count > capacity_) {
    claimed_ = std::make_unique<std::atomic<std::uint64_t>[]>(count);
    capacity_ = count;
  }
  call_ = call;
  task_ = task;
  count_ = count;
  const std::uint64_t round = round_.load() + 1;
  open_.store(round);
  round_.store(round);
  round_.notify_all();
  work(round, 0);
  open_.store(0);
  spin_until([this] { return active_.load() == 0; });
  for (std::uint64_t left; (left = active_.load()) != 0;) active_.wait(left);
  if (failed_.exchange(false)) std::rethrow_exception(std::exchange(error_, nullptr));
}

void ThreadPool::run_item(std::size_t item, unsigned worker) noexcept {
  try {
    call_(task_, item, worker);
  } catch (...) {
    if (!failed_.exchange(true)) error_ = std::current_exception();
  }
}

void ThreadPool::wait_for_work(unsigned worker) {
  for (std::uint64_t seen = 0;;) {
    spin_until([&] { return round_.load() != seen; });
    round_.wait(seen);
    seen = round_.load();
    if (stop_.load()) return;
    active_.fetch_add(1);
    if (const std::uint64_t round = open_.load(); round != 0) work(round, worker);
    if (active_.fetch_sub(1) == 1) active_.notify_one();
  }
}

bool ThreadPool::claim(std::size_t item, std::uint64_t round) {
  return claimed_[item].load(std::memory_order_relaxed) != round &&
         claimed_[item].exchange(round, std::memory_order_acq_rel) != round;
}

void ThreadPool::work(std::uint64_t round, unsigned worker) {
  const auto share_begin = [this](unsigned w) { return count_ * w / size(); };
  for (std::size_t item = share_begin(worker); item < share_begin(worker + 1); ++item)
    if (claim(item, round)) run_item(item, worker);
  // Steal unstarted items from the end of the other shares.
  for (unsigned k = 1; k < size(); ++k) {
    const unsigned other = (worker + k) % size();
    for (std::size_t item = share_begin(other + 1); item-- > share_begin(other);)
      if (claim(item, round)) run_item(item, worker);
  }
}

}  // namespace scree
