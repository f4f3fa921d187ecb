#include "band/backend/elimination.hpp"

#include "matrices.hpp"

#include <algorithm>
#include <csignal>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::response;
using scree::test::Sparse;

namespace {

// Of a grid of side × side unknowns that are coupled to their neighbours, and some more unknowns alone.
Sparse grid_pattern(int side, int alone) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int a, int b) { entries.emplace_back(a, b, 1), entries.emplace_back(b, a, 1); };
  for (int n = 0; n < side * side; ++n) {
    if (n % side + 1 < side) couple(n, n + 1);
    if (n + side < side * side) couple(n, n + side);
  }
  for (int n = 0; n < side * side + alone; ++n) entries.emplace_back(n, n, 1);
  Sparse a(side * side + alone, side * side + alone);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

// Later unknowns that each is coupled to once those before it are eliminated, entry by entry.
std::vector<std::set<int>> filled(const Sparse& pattern, const Elimination& plan) {
  std::vector<std::set<int>> rows(plan.order.size());
  for (int column = 0; column < pattern.cols(); ++column)
    for (Sparse::InnerIterator entry(pattern, column); entry; ++entry) {
      const int a = plan.place[std::size_t(column)], b = plan.place[std::size_t(entry.row())];
      if (a < b) rows[std::size_t(a)].insert(b);
    }
  for (const std::set<int>& of : rows)
    if (!of.empty()) rows[std::size_t(*of.begin())].insert(std::next(of.begin()), of.end());
  return rows;
}

volatile std::sig_atomic_t requests = 0;
void count_request(int) { requests = requests + 1; }

}  // namespace

// METIS takes over SIGTERM, and sets its handler back so that it works once.
TEST_CASE("SIGTERM is handled any number of times after an elimination was planned", "[response]") {
  struct sigaction counting {
  }, before{};
  counting.sa_handler = count_request;
  sigaction(SIGTERM, &counting, &before);
  plan_elimination(grid_pattern(20, 0));
  requests = 0;
  for (int k = 0; k < 3; ++k) {
    struct sigaction now {};
    sigaction(SIGTERM, nullptr, &now);
    REQUIRE(now.sa_handler == count_request);
    raise(SIGTERM);
  }
  CHECK(requests == 3);
  sigaction(SIGTERM, &before, nullptr);
}

TEST_CASE("every unknown is eliminated once, in adjacent groups", "[response]") {
  for (const auto& [side, alone] : {std::pair{1, 0}, {0, 5}, {7, 3}, {20, 0}}) {
    const Elimination plan = plan_elimination(grid_pattern(side, alone));
    const int size = side * side + alone;
    for (int k = 0; k < size; ++k) CHECK(plan.place[std::size_t(plan.order[std::size_t(k)])] == k);
    int next = 0;
    for (const Supernode& node : plan.nodes) {
      CHECK(node.first == next);
      CHECK(node.width > 0);
      next += node.width;
    }
    CHECK(next == size);
  }
}

TEST_CASE("a group has room for all couplings that elimination makes, and passes them to its parent",
          "[response]") {
  const Sparse pattern = grid_pattern(20, 2);
  const Elimination plan = plan_elimination(pattern);
  const std::vector<std::set<int>> rows = filled(pattern, plan);
  std::size_t needed = 0, given = 0;
  for (const Supernode& node : plan.nodes) {
    const int end = node.first + node.width;
    CHECK(std::is_sorted(node.rows.begin(), node.rows.end()));
    std::set<int> allowed(node.rows.begin(), node.rows.end());
    for (int k = node.first; k < end; ++k) {
      allowed.insert(k);
      for (const int row : rows[std::size_t(k)]) CHECK(allowed.count(row) + (row < end) > 0);
      needed += rows[std::size_t(k)].size();
      given += node.rows.size() + std::size_t(end - k - 1);
    }
    if (node.rows.empty()) {
      CHECK(node.parent == -1);
      continue;
    }
    CHECK(node.rows.front() >= end);
    REQUIRE(node.parent >= 0);
    const Supernode& parent = plan.nodes[std::size_t(node.parent)];
    CHECK(node.rows.front() >= parent.first);
    CHECK(node.rows.front() < parent.first + parent.width);
    for (const int row : node.rows)
      CHECK((row < parent.first + parent.width ||
             std::binary_search(parent.rows.begin(), parent.rows.end(), row)));
  }
  // Nested dissection of a grid of n unknowns fills about 31/4 n log2 n entries at most (George 1973): 27000.
  // Groups up to 16 wide have zeros too.
  CHECK(needed < 27000);
  CHECK(given < 3 * needed);
}
