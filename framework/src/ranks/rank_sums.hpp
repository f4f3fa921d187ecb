#pragma once

#include "machine/exact_sum.hpp"

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include <scree/ranks.hpp>

namespace scree {

// Sums over the tiles of all ranks and largest numbers of all ranks, in one message. Sums are rounded once,
// so that they do not depend on which rank has which tile.
class RankSums {
 public:
  // Null: one process has all tiles.
  explicit RankSums(Ranks* ranks) {
    if (ranks) message_.reset(new Message{*ranks});
  }

  bool over_ranks() const { return message_ != nullptr; }
  // Sets a number to the sum of term(tile) over all tiles, once `close` is called; with one process at once.
  // Each rank gives all tiles, of which the term is 0 for tiles of other ranks. A single tile counts as it
  // is.
  template <class Tiles, class Term>
  void sum(double& target, const Tiles& tiles, const Term& term) {
    if (!message_) {
      target = exact_sum(tiles, term);
    } else if (tiles.size() == 1) {
      add_single(target, term(*tiles.begin()));
    } else {
      ExactSum sum;
      for (const auto& tile : tiles) sum.add(term(tile));
      add(target, sum);
    }
  }
  // Sets a number to a sum of tiles, of which each rank gives its part; -0 becomes 0.
  void sum(double& target, const ExactSum& part) {
    if (message_)
      add(target, part);
    else
      target = part.value();
  }
  // Sets a number, which must not be NaN, to the largest of all ranks.
  void largest(double& number) {
    if (message_) message_->largest.push_back(&number);
  }
  // Sets a flag to whether it is set on all ranks.
  void all(bool& flag) {
    if (message_) message_->flags.push_back(&flag);
  }
  // Sets a count to its sum over all ranks.
  void total(std::int64_t& count) {
    if (message_) message_->counts.push_back(&count);
  }
  // Exchanges what was given.
  void close() {
    if (message_) exchange();
  }

 private:
  // What is exchanged; one process has none.
  struct Message {
    Ranks& ranks;
    std::vector<double*> singles = {}, sums = {}, largest = {};
    std::vector<bool*> flags = {};
    std::vector<std::int64_t*> counts = {};
    std::vector<std::int64_t> bits_of_singles = {}, words_of_sums = {};
  };

  void add_single(double& target, double term);
  void add(double& target, const ExactSum& sum);
  void exchange();

  std::unique_ptr<Message> message_;
};

}  // namespace scree
