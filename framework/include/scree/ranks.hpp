#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <scree/tile_graph.hpp>

namespace scree {

// The processes (ranks) that compute one scene together, and the messages between them. Every rank makes the
// same calls in the same order.
class Ranks {
 public:
  using Bytes = std::vector<std::byte>;

  virtual ~Ranks() = default;

  // Of this process, from 0; the first one reads commands and writes results.
  virtual unsigned rank() const = 0;
  virtual unsigned size() const = 0;

  // Whether tiles are dealt to ranks at random after each search, which changes no result: for tests.
  virtual bool deals_at_random() const { return false; }
  // The rank of each tile, below size(), such that ranks have about as much work and few pairs are between
  // tiles of different ranks; nothing if no partitioner is available. For the first rank alone.
  virtual std::vector<std::uint32_t> partition(const TileGraph&) { return {}; }

  // Gives all ranks what the first rank has in `data`, of the same size on each.
  virtual void broadcast(std::span<std::byte> data) = 0;
  // Gives all ranks the largest of each number, none of which may be NaN, and the sum of each count.
  virtual void combine(std::span<double> largest, std::span<std::int64_t> sums) = 0;
  // Sends outgoing[r] to each rank r; returns what each rank has sent here.
  virtual std::vector<Bytes> exchange(const std::vector<Bytes>& outgoing) = 0;

  // A message to another rank, or room for one from it, of a length that both know.
  struct Sent {
    unsigned to;
    std::span<const double> numbers;
  };
  struct Received {
    unsigned from;
    std::span<double> numbers;
  };
  // Begins to send and to receive, at most one message from a rank to another; the memory must stay until
  // `finish` returns, after which all messages have come.
  virtual void begin(std::span<const Sent> sent, std::span<const Received> received) = 0;
  virtual void finish() = 0;
};

}  // namespace scree
