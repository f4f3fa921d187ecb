#include "no_threads.hpp"

#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/thread_pool.hpp>

using scree::ThreadPool;

TEST_CASE("each item is done once in every round, for any count and any number of threads", "[threads]") {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    ThreadPool pool(threads);
    REQUIRE(pool.size() == threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 9u, 64u, 1000u}) {
      std::vector<std::atomic<int>> calls(count);
      std::atomic<bool> strangers = false;
      for (int round = 1; round <= 20; ++round) {
        pool.each(count, [&](std::size_t item, unsigned worker) {
          calls.at(item).fetch_add(1, std::memory_order_relaxed);
          if (worker >= threads) strangers = true;
        });
        for (const auto& number : calls) REQUIRE(number.load(std::memory_order_relaxed) == round);
      }
      CHECK(!strangers);
    }
  }
}

TEST_CASE("writes of one round are visible to all workers in the next", "[threads]") {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    ThreadPool pool(threads);
    std::vector<std::uint64_t> now(257), next(257);
    std::iota(now.begin(), now.end(), 0u);
    std::vector<std::uint64_t> expected = now;
    // Every element is summed with its neighbours of the previous round, which other workers wrote.
    const auto mix = [](const std::vector<std::uint64_t>& in, std::size_t i) {
      return in[i] * 3 + in[(i + 1) % in.size()] + in[(i + in.size() - 1) % in.size()];
    };
    for (int round = 0; round < 30; ++round) {
      pool.each(now.size(), [&](std::size_t i, unsigned) { next[i] = mix(now, i); });
      std::swap(now, next);
      std::vector<std::uint64_t> serial(expected.size());
      for (std::size_t i = 0; i < serial.size(); ++i) serial[i] = mix(expected, i);
      expected = serial;
    }
    CHECK(now == expected);
  }
}

TEST_CASE("with one thread everything runs in the caller", "[threads]") {
  ThreadPool pool(1);
  std::set<std::thread::id> where;
  pool.each(5, [&](std::size_t, unsigned) { where.insert(std::this_thread::get_id()); });
  CHECK(where == std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST_CASE("workers take part in long rounds, also after they slept", "[threads]") {
  ThreadPool pool(3);
  for (int round = 0; round < 3; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    // Two items that wait for each other: one thread alone could not complete both.
    std::atomic<int> begun = 0;
    pool.each(2, [&](std::size_t, unsigned) {
      begun.fetch_add(1);
      while (begun.load() < 2) std::this_thread::yield();
    });
    CHECK(begun == 2);
  }
}

TEST_CASE("a delayed worker does not delay the others: its unstarted items are stolen", "[threads]") {
  ThreadPool pool(2);
  std::atomic<bool> others_done = false;
  std::atomic<int> done = 0;
  // Item 50 waits for all others, including those of its own share.
  pool.each(100, [&](std::size_t item, unsigned) {
    if (item == 50)
      while (!others_done.load()) std::this_thread::yield();
    if (item != 50 && done.fetch_add(1) + 1 == 99) others_done = true;
  });
  CHECK(done == 99);
}

TEST_CASE("an exception of a task reaches the caller, and the pool keeps working", "[threads]") {
  for (unsigned threads = 1; threads <= 4; ++threads) {
    ThreadPool pool(threads);
    for (const std::size_t bad : {0u, 3u, 7u}) {
      std::atomic<int> done = 0;
      const auto task = [&](std::size_t item, unsigned) {
        if (item == bad) throw std::runtime_error("item");
        done.fetch_add(1);
      };
      CHECK_THROWS_WITH(pool.each(8, task), "item");
      if (threads > 1) CHECK(done == 7);
      done = 0;
      pool.each(8, [&](std::size_t, unsigned) { done.fetch_add(1); });
      CHECK(done == 8);
    }
    CHECK_THROWS_WITH(pool.each(8, [](std::size_t, unsigned) { throw std::runtime_error("all"); }), "all");
  }
}

TEST_CASE("an unused pool, and one for zero threads, can be destroyed", "[threads]") {
  for (unsigned threads = 0; threads <= 8; ++threads) {
    const ThreadPool pool(threads);
    CHECK(pool.size() == (threads == 0 ? 1 : threads));
  }
}

TEST_CASE("items that are started in order leave none out before the last one that was started",
          "[threads]") {
  for (const unsigned threads : {1u, 4u}) {
    ThreadPool pool(threads);
    std::vector<std::atomic<bool>> started(200);
    std::atomic<std::size_t> count = 0;
    const auto each = [&](std::size_t failing) {
      pool.each_in_order(started.size(), [&](std::size_t item, unsigned) {
        if (item == failing) throw std::runtime_error("of an item");
        started[item] = true;
        ++count;
      });
    };
    each(started.size());
    CHECK(count == started.size());
    for (auto& item : started) item = false;
    count = 0;
    CHECK_THROWS_WITH(each(50), "of an item");
    for (std::size_t item = 0; item < 50; ++item) CHECK(started[item]);
    if (threads == 1) CHECK(count == 50);
  }
}

TEST_CASE("a pool has as many threads as can be started, if it may", "[threads]") {
  const scree::test::NoThreads none;
  CHECK_THROWS_WITH(ThreadPool(4),
                    Catch::Contains("only 1 of 4 threads could be started; use fewer threads"));
  ThreadPool pool(4, ThreadPool::IfTooFew::use_fewer);
  CHECK(pool.size() == 1);
  int calls = 0;
  pool.each_in_order(5, [&](std::size_t, unsigned) { ++calls; });
  CHECK(calls == 5);
}
