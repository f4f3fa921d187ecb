#include "checks.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <limits>

#include <fmt/format.h>

namespace scree::test {

void Checks::require(bool holds, const std::string& what) {
  if (holds) return;
  if (failures_++ < 5) fmt::print(stderr, "rank {}: {}\n", rank_, what);
}

std::int64_t Checks::failures(Ranks& ranks) const {
  std::int64_t all = failures_;
  ranks.combine({}, {&all, 1});
  return all;
}

std::size_t random_size(Random& random, std::size_t largest) {
  if (random() % 5 == 0) return 0;
  const unsigned bits = unsigned(random() % std::uint64_t(std::bit_width(largest)));
  return std::min<std::size_t>(largest, (std::size_t(1) << bits) + random() % (std::size_t(1) << bits));
}

void check_broadcast(Ranks& ranks, Random& random, Checks& checks) {
  std::vector<std::byte> of_first(random_size(random, 100'000));
  for (std::byte& byte : of_first) byte = std::byte(random());
  std::vector<std::byte> data = of_first;
  if (ranks.rank() > 0) std::fill(data.begin(), data.end(), std::byte(0));
  ranks.broadcast(data);
  checks.require(data == of_first, fmt::format("broadcast of {} bytes", data.size()));
}

namespace {

// Of any sign, with both zeros and infinities among them.
double random_number(Random& random) {
  switch (random() % 8) {
    case 0:
      return -0.0;
    case 1:
      return 0.0;
    case 2:
      return -std::numeric_limits<double>::infinity();
    default:
      return std::ldexp(double(std::int64_t(random())), int(random() % 200) - 100);
  }
}

// -0 counts as smaller than 0.
bool is_smaller(double one, double other) {
  return one < other || (one == other && std::signbit(one) && !std::signbit(other));
}

}  // namespace

// Counts are any 64 bits, whose sums wrap around.
void check_combine(Ranks& ranks, Random& random, Checks& checks) {
  std::vector<double> own_numbers, largest(random_size(random, 6'000));
  std::vector<std::int64_t> own_counts, sums(random_size(random, 6'000));
  for (double& number : largest) {
    for (unsigned r = 0; r < ranks.size(); ++r) {
      const double of_rank = random_number(random);
      if (r == ranks.rank()) own_numbers.push_back(of_rank);
      if (r == 0 || is_smaller(number, of_rank)) number = of_rank;
    }
  }
  for (std::int64_t& sum : sums) {
    std::uint64_t of_all = 0;
    for (unsigned r = 0; r < ranks.size(); ++r) {
      const std::uint64_t of_rank = random();
      if (r == ranks.rank()) own_counts.push_back(std::int64_t(of_rank));
      of_all += of_rank;
    }
    sum = std::int64_t(of_all);
  }
  ranks.combine(own_numbers, own_counts);
  const auto same_bits = [](double one, double other) {
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
  };
  checks.require(std::equal(largest.begin(), largest.end(), own_numbers.begin(), same_bits),
                 fmt::format("largest of {} numbers", largest.size()));
  checks.require(sums == own_counts, fmt::format("sums of {} counts", sums.size()));
}

}  // namespace scree::test
