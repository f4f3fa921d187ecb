#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/thread_pool.hpp>

using scree::ThreadPool;

TEST_CASE("each worker is called once in every round") {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    ThreadPool pool(threads);
    REQUIRE(pool.size() == threads);
    std::vector<std::atomic<int>> calls(threads);
    const int rounds = 50;
    for (int round = 1; round <= rounds; ++round) {
      pool.run([&](unsigned worker) { calls.at(worker).fetch_add(1, std::memory_order_relaxed); });
      for (const auto& count : calls) REQUIRE(count.load(std::memory_order_relaxed) == round);
    }
  }
}

TEST_CASE("parts cover every index once, in order, for any count and any number of threads") {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    const ThreadPool pool(threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 9u, 64u, 1000u, 1001u}) {
      std::size_t next = 0;
      for (unsigned worker = 0; worker < threads; ++worker) {
        const ThreadPool::Part part = pool.part(count, worker);
        REQUIRE(part.begin == next);
        REQUIRE(part.end >= part.begin);
        // Shares differ by one at most.
        REQUIRE(part.end - part.begin <= count / threads + 1);
        next = part.end;
      }
      REQUIRE(next == count);
    }
  }
}

TEST_CASE("what a round wrote is seen by all workers in the next") {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    ThreadPool pool(threads);
    std::vector<std::uint64_t> now(257), next(257);
    std::iota(now.begin(), now.end(), 0u);
    std::vector<std::uint64_t> expected = now;
    // Every element is summed with its neighbours of the round before, which other workers wrote.
    const auto mix = [](const std::vector<std::uint64_t>& in, std::size_t i) {
      return in[i] * 3 + in[(i + 1) % in.size()] + in[(i + in.size() - 1) % in.size()];
    };
    for (int round = 0; round < 30; ++round) {
      pool.run([&](unsigned worker) {
        const ThreadPool::Part part = pool.part(now.size(), worker);
        for (std::size_t i = part.begin; i < part.end; ++i) next[i] = mix(now, i);
      });
      std::swap(now, next);
      std::vector<std::uint64_t> serial(expected.size());
      for (std::size_t i = 0; i < serial.size(); ++i) serial[i] = mix(expected, i);
      expected = serial;
    }
    CHECK(now == expected);
  }
}

TEST_CASE("one thread works in the caller, more in as many threads") {
  const std::thread::id caller = std::this_thread::get_id();
  for (unsigned threads = 1; threads <= 4; ++threads) {
    ThreadPool pool(threads);
    std::vector<std::thread::id> where(threads);
    pool.run([&](unsigned worker) { where[worker] = std::this_thread::get_id(); });
    CHECK(where[0] == caller);
    CHECK(std::set<std::thread::id>(where.begin(), where.end()).size() == threads);
  }
}

TEST_CASE("workers that fell asleep wake up for the next round") {
  ThreadPool pool(3);
  std::atomic<int> calls = 0;
  for (int round = 0; round < 3; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pool.run([&](unsigned) { calls.fetch_add(1, std::memory_order_relaxed); });
  }
  CHECK(calls == 9);
}

TEST_CASE("a pool that never worked, or that was asked for no thread, ends in peace") {
  for (unsigned threads = 0; threads <= 8; ++threads) {
    const ThreadPool pool(threads);
    CHECK(pool.size() == (threads == 0 ? 1 : threads));
  }
}
