#include "checks.hpp"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <vector>

namespace scree::test {

namespace {

volatile std::sig_atomic_t requests = 0;

void on_signal(int) { requests = requests + 1; }

// Tiles on a square, row by row, with many pairs along the columns; tiles of the left half have twice the
// work.
TileGraph square(std::uint32_t side) {
  TileGraph graph;
  for (std::uint32_t tile = 0; tile < side * side; ++tile) {
    graph.work.push_back(tile % side < side / 2 ? 2e-3 : 1e-3);
    if (tile % side + 1 < side) graph.edges.push_back({tile, tile + 1, 10});
    if (tile + side < side * side) graph.edges.push_back({tile, tile + side, 200});
  }
  return graph;
}

std::uint64_t pairs_across(const TileGraph& graph, const std::vector<std::uint32_t>& map) {
  std::uint64_t pairs = 0;
  for (const TileGraph::Edge& edge : graph.edges) pairs += map[edge.tile] == map[edge.other] ? 0 : edge.pairs;
  return pairs;
}

// The map cuts the square across its rows alone, in stripes of columns of about the same work.
void check_map(const TileGraph& graph, const std::vector<std::uint32_t>& map, unsigned ranks,
               std::uint32_t side, Checks& checks) {
  std::vector<double> work(ranks, 0);
  double all = 0;
  for (std::size_t tile = 0; tile < map.size(); ++tile) {
    if (map[tile] >= ranks) return checks.require(false, "only ranks below their number");
    work[map[tile]] += graph.work[tile], all += graph.work[tile];
  }
  checks.require(*std::max_element(work.begin(), work.end()) < 1.1 * all / ranks, "about the same work");
  checks.require(pairs_across(graph, map) < 2 * (ranks - 1) * 10 * side, "few pairs across");
}

// That METIS takes for a failure of its own.
void check_signal_meanwhile(Ranks& ranks, Checks& checks) {
  const TileGraph graph = square(300);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGTERM;
  timer_t timer{};
  itimerspec soon{};
  soon.it_value.tv_nsec = 20'000'000;
  checks.require(timer_create(CLOCK_MONOTONIC, &event, &timer) == 0, "a timer");
  checks.require(timer_settime(timer, 0, &soon, nullptr) == 0, "a timer that runs");
  const std::vector<std::uint32_t> map = ranks.partition(graph);
  for (int waited = 0; requests == 0 && waited < 5000; ++waited) {  // ms
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  checks.require(requests == 1, "one request to stop");
  checks.require(map.empty() || map.size() == graph.work.size(), "a whole map or none");
  checks.require(ranks.partition(graph).size() == graph.work.size(), "a map afterwards");
  timer_delete(timer);
}

}  // namespace

void check_partition(Ranks& ranks, bool with_partitioner, Checks& checks) {
  if (ranks.rank() > 0 || ranks.size() == 1) return;
  constexpr std::uint32_t side = 24;
  const TileGraph graph = square(side);
  struct sigaction action {
  }, after{};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGTERM, &action, nullptr);
  const std::vector<std::uint32_t> map = ranks.partition(graph);
  sigaction(SIGTERM, nullptr, &after);
  checks.require(
      after.sa_handler == on_signal && !(after.sa_flags & int(SA_RESETHAND)) && (after.sa_flags & SA_RESTART),
      "the handler of a signal stays");
  if (!with_partitioner) return checks.require(map.empty(), "no partitioner, no map");
  if (map.size() != graph.work.size()) return checks.require(false, "a rank for each tile");
  check_map(graph, map, ranks.size(), side, checks);
  checks.require(ranks.partition(graph) == map, "the same map again");
  // Weights whose sums need more than 32 bits.
  TileGraph large = graph;
  for (TileGraph::Edge& edge : large.edges) edge.pairs *= 20'000'000;
  for (double& work : large.work) work *= 1e15;
  const std::vector<std::uint32_t> of_large = ranks.partition(large);
  if (of_large.size() != map.size()) return checks.require(false, "a rank for each tile of a large scene");
  check_map(graph, of_large, ranks.size(), side, checks);
#ifndef __SANITIZE_THREAD__  // which delays signals
  check_signal_meanwhile(ranks, checks);
#endif
}

}  // namespace scree::test
