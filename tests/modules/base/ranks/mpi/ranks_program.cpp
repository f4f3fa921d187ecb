#include "checks.hpp"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/ranks/join_ranks.hpp>
#include <scree/ranks/launcher.hpp>

// ranks_program WHAT SIZE [SEED]: one of SIZE ranks that mpirun starts. See mpi_test.sh.

namespace scree::test {
namespace {

std::unique_ptr<Ranks> join(unsigned size, std::size_t piece = ranks::largest_piece) {
  auto joined = ranks::join_ranks(piece);
  if (joined->size() != size || joined->rank() >= size || ranks::is_one_of_several_tasks() != (size > 1))
    throw Error(fmt::format("rank {} of {}, not of {}", joined->rank(), joined->size(), size));
  return joined;
}

int check_all(Ranks& ranks, std::uint64_t seed, int rounds, std::size_t largest) {
  Checks checks(ranks.rank());
  Random random(seed);
  for (int round = 0; round < rounds; ++round) {
    check_broadcast(ranks, random, checks);
    check_combine(ranks, random, checks);
    check_exchange(ranks, random, largest, checks);
    check_messages(ranks, random, largest, checks);
  }
  const std::int64_t failures = checks.failures(ranks);
  if (ranks.rank() == 0) fmt::print("{} rounds from seed {}: {} failures\n", rounds, seed, failures);
  return failures > 0;
}

int check_partition_alone(Ranks& ranks) {
  Checks checks(ranks.rank());
  check_partition(ranks, SCREE_METIS, checks);
  const std::int64_t failures = checks.failures(ranks);
  if (ranks.rank() == 0) fmt::print("partition: {} failures\n", failures);
  return failures > 0;
}

// The first rank waits for a message that the last one does not send.
[[noreturn]] void fail_between(Ranks& ranks) {
  std::vector<double> numbers(1'000'000);
  const Ranks::Received message = {ranks.size() - 1, numbers};
  ranks.begin({}, {&message, ranks.rank() == 0 ? std::size_t(1) : 0});
  throw Error("", fmt::format("rank {} fails", ranks.rank()), "", ExitStatus::blow_up);
}

// The room for the message is too small.
int receive_too_much(Ranks& ranks) {
  double number = 0;
  const std::array<double, 3> numbers = {1, 2, 3};
  const Ranks::Sent sent = {0, numbers};
  const Ranks::Received received = {ranks.size() - 1, {&number, 1}};
  const bool first = ranks.rank() == 0, last = ranks.rank() == ranks.size() - 1;
  ranks.begin({&sent, last ? std::size_t(1) : 0}, {&received, first ? std::size_t(1) : 0});
  ranks.finish();
  return 0;
}

// Messages of more bytes than an int counts, which take 9 GB on two ranks: by hand.
int check_longest(Ranks& ranks) {
  constexpr std::size_t count = (std::size_t(1) << 31) + 12'344;
  const unsigned to = (ranks.rank() + 1) % ranks.size();
  const unsigned from = (ranks.rank() + ranks.size() - 1) % ranks.size();
  Checks checks(ranks.rank());
  const auto at = [](unsigned rank, std::size_t k) { return std::byte(k * 37 + (k >> 20) + rank); };
  const auto has_come = [&](const Ranks::Bytes& bytes, unsigned rank) {
    bool same = bytes.size() == count;
    for (std::size_t k = 0; same && k < count; ++k) same = bytes[k] == at(rank, k);
    return same;
  };
  std::vector<Ranks::Bytes> outgoing(ranks.size());
  outgoing[to].resize(count);
  for (std::size_t k = 0; k < count; ++k) outgoing[to][k] = at(ranks.rank(), k);
  std::vector<Ranks::Bytes> incoming = ranks.exchange(outgoing);
  checks.require(has_come(incoming[from], from), "exchange");
  std::fill(incoming[from].begin(), incoming[from].end(), std::byte(0));
  const Ranks::Sent sent = {to, {reinterpret_cast<const double*>(outgoing[to].data()), count / 8}};
  const Ranks::Received received = {from, {reinterpret_cast<double*>(incoming[from].data()), count / 8}};
  ranks.begin({&sent, 1}, {&received, 1});
  ranks.finish();
  checks.require(has_come(incoming[from], from), "message");
  ranks.broadcast(outgoing[to]);
  checks.require(has_come(outgoing[to], 0), "broadcast");
  return checks.failures(ranks) > 0;
}

int run(const std::string& what, unsigned size, std::uint64_t seed) {
  if (what == "pieces") return check_all(*join(size, 48), seed, 30, 500);
  const std::unique_ptr<Ranks> ranks = join(size);
  if (what == "messages") return check_all(*ranks, seed, 300, 20'000);
  if (what == "long-messages") return check_all(*ranks, seed, 6, 3'000'000);
  if (what == "longest-messages") return check_longest(*ranks);
  if (what == "partition") return check_partition_alone(*ranks);
  if (what == "failure-between") fail_between(*ranks);
  if (what == "too-much") return receive_too_much(*ranks);
  if (what == "joined-twice") ranks::join_ranks();
  if (what == "failure-of-all" || (what == "failure-of-one" && ranks->rank() == size - 1))
    throw Error("", fmt::format("rank {} fails", ranks->rank()), "", ExitStatus::blow_up);
  ranks->combine({}, {});
  std::int64_t count = 1;
  ranks->combine({}, {&count, 1});
  return count != size;
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  try {
    return scree::test::run(argv[1], unsigned(std::atoi(argv[2])),
                            argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  } catch (const scree::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return int(error.status());
  }
}
