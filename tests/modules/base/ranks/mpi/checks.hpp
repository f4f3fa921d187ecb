#pragma once

#include <cstdint>
#include <random>
#include <string>

#include <scree/ranks.hpp>

namespace scree::test {

// Counts what does not come out as it must, on this rank. Goes on after a failure, so that all ranks make the
// same calls.
class Checks {
 public:
  explicit Checks(unsigned rank) : rank_(rank) {}

  void require(bool holds, const std::string& what);
  // The sum over all ranks.
  std::int64_t failures(Ranks& ranks) const;

 private:
  unsigned rank_;
  std::int64_t failures_ = 0;
};

// The same numbers on all ranks, each of which knows thus what the others send.
using Random = std::mt19937_64;

// From 0 to `largest`, of any order of magnitude; 0 in a fifth of all cases.
std::size_t random_size(Random& random, std::size_t largest);

void check_broadcast(Ranks& ranks, Random& random, Checks& checks);
void check_combine(Ranks& ranks, Random& random, Checks& checks);
void check_exchange(Ranks& ranks, Random& random, std::size_t largest, Checks& checks);
// with_partitioner: the library was built with one.
void check_partition(Ranks& ranks, bool with_partitioner, Checks& checks);
void check_messages(Ranks& ranks, Random& random, std::size_t largest, Checks& checks);

}  // namespace scree::test
