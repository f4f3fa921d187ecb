#include "no_threads.hpp"
#include "scenes.hpp"

#include <stdexcept>
#include <thread>

#include <catch2/catch.hpp>

#include <scree/threads.hpp>

using namespace scree;
using scree::test::NoThreads;

TEST_CASE("work in the background has a thread of its own, and is done here where there is none",
          "[threads]") {
  bool has_thread = false;
  CHECK(in_background([] { return std::this_thread::get_id(); }, &has_thread).get() !=
        std::this_thread::get_id());
  CHECK(has_thread);
  const NoThreads none;
  REQUIRE_THROWS_AS(std::thread([] {}), std::system_error);
  bool done = false;
  auto id = in_background([&done] { return done = true, std::this_thread::get_id(); }, &has_thread);
  CHECK(done);
  CHECK(!has_thread);
  CHECK(id.get() == std::this_thread::get_id());
  auto failed = in_background([]() -> int { throw std::runtime_error("of the work"); });
  CHECK_THROWS_WITH(failed.get(), "of the work");
}

TEST_CASE("whether threads can be started is found by starting them", "[threads]") {
  CHECK(can_start_threads(2));
  const NoThreads none;
  CHECK(!can_start_threads(1));
  CHECK(can_start_threads(0));
}

TEST_CASE("a simulation gives the same state where no thread can be started", "[threads]") {
  using namespace scree::test;
  const Simulation s(
      scene(2, 1e-4, {body(1, 1, 1, {}, {})}, {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}}));
  const State with = s.state();
  const NoThreads none;
  CHECK(s.state() == with);
}
