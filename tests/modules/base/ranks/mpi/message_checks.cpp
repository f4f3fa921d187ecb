#include "checks.hpp"

#include <limits>

#include <fmt/format.h>

namespace scree::test {

namespace {

// What a rank sends to another, which both know: its length and a number from which its content follows.
struct Planned {
  std::size_t size;
  std::uint64_t seed;

  std::uint64_t operator[](std::size_t k) const { return (seed + k) * 0x9e3779b97f4a7c15u; }
};

// plan[from][to]
using Plan = std::vector<std::vector<Planned>>;

Plan random_plan(unsigned ranks, Random& random, std::size_t largest) {
  Plan plan(ranks);
  for (auto& from : plan)
    for (unsigned to = 0; to < ranks; ++to) from.push_back({random_size(random, largest), random()});
  return plan;
}

std::byte byte_of(const Planned& message, std::size_t k) { return std::byte(message[k] >> 56); }
double number_of(const Planned& message, std::size_t k) { return double(message[k]); }

bool has_come(const Planned& message, std::span<const double> numbers) {
  for (std::size_t k = 0; k < message.size; ++k)
    if (numbers[k] != number_of(message, k)) return false;
  return numbers.size() == message.size;
}

// Takes about as long on each rank as messages are under way.
double compute(std::size_t steps) {
  double x = 0.3;
  for (std::size_t k = 0; k < steps; ++k) x = 3.9 * x * (1 - x);
  return x;
}

}  // namespace

void check_exchange(Ranks& ranks, Random& random, std::size_t largest, Checks& checks) {
  const Plan plan = random_plan(ranks.size(), random, largest);
  std::vector<Ranks::Bytes> outgoing;
  for (const Planned& message : plan[ranks.rank()]) {
    outgoing.emplace_back(message.size);
    for (std::size_t k = 0; k < message.size; ++k) outgoing.back()[k] = byte_of(message, k);
  }
  const std::vector<Ranks::Bytes> incoming = ranks.exchange(outgoing);
  checks.require(incoming.size() == ranks.size(), "exchange returns a list of each rank");
  for (unsigned from = 0; from < ranks.size(); ++from) {
    const Planned& message = plan[from][ranks.rank()];
    bool same = incoming[from].size() == message.size;
    for (std::size_t k = 0; same && k < message.size; ++k) same = incoming[from][k] == byte_of(message, k);
    checks.require(same, fmt::format("exchange: {} bytes from rank {}", message.size, from));
  }
}

// Messages of no numbers are left out by some ranks and given by others. Meanwhile the rank computes, and
// combines and exchanges, which must not be taken for the messages.
void check_messages(Ranks& ranks, Random& random, std::size_t largest, Checks& checks) {
  const Plan plan = random_plan(ranks.size(), random, largest);
  const bool leaves_out_empty = random() % 2 == ranks.rank() % 2;
  std::vector<std::vector<double>> outgoing(ranks.size()), incoming(ranks.size());
  std::vector<Ranks::Sent> sent;
  std::vector<Ranks::Received> received;
  for (unsigned r = 0; r < ranks.size(); ++r) {
    const Planned &to = plan[ranks.rank()][r], &from = plan[r][ranks.rank()];
    for (std::size_t k = 0; k < to.size; ++k) outgoing[r].push_back(number_of(to, k));
    incoming[r].assign(from.size, std::numeric_limits<double>::quiet_NaN());
    if (to.size > 0 || !leaves_out_empty) sent.push_back({r, outgoing[r]});
    if (from.size > 0 || !leaves_out_empty) received.push_back({r, incoming[r]});
  }
  ranks.begin(sent, received);
  sent.clear(), received.clear();
  checks.require(compute(random() % 20'000) > 0, "computation");
  if (random() % 3 == 0) check_combine(ranks, random, checks);
  if (random() % 3 == 0) check_exchange(ranks, random, largest, checks);
  ranks.finish();
  for (unsigned from = 0; from < ranks.size(); ++from) {
    const Planned& message = plan[from][ranks.rank()];
    checks.require(has_come(message, incoming[from]),
                   fmt::format("message of {} numbers from rank {}", message.size, from));
  }
}

}  // namespace scree::test
