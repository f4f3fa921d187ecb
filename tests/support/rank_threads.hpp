#pragma once

#include <algorithm>
#include <barrier>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include <scree/ranks.hpp>

namespace scree::test {

// Ranks that are threads of one process: messages are copies between their memories. Sums are added from the
// last rank to the first and messages come late, so that nothing may depend on when and in which order they
// come.
class RankThreads {
 public:
  // partition: see Ranks; may be empty.
  using Partition = std::function<std::vector<std::uint32_t>(const TileGraph&)>;
  explicit RankThreads(unsigned size, bool at_random = false, Partition partition = {})
      : size_(size), at_random_(at_random), partition_(std::move(partition)), meeting_(size), given_(size) {}

  // Calls work(ranks) on each rank; throws what the first rank that failed has thrown. A rank that fails
  // while others wait for it ends the program.
  void run(const std::function<void(Ranks&)>& work) {
    std::vector<std::exception_ptr> errors(size_);
    {
      std::vector<std::jthread> threads;
      for (unsigned rank = 0; rank < size_; ++rank)
        threads.emplace_back([&, rank] {
          Member member(*this, rank);
          try {
            work(member);
          } catch (...) {
            errors[rank] = std::current_exception();
          }
        });
    }
    for (const std::exception_ptr& error : errors)
      if (error) std::rethrow_exception(error);
  }

 private:
  // What a rank gives the others between two meetings.
  struct Given {
    std::span<std::byte> broadcast;
    std::vector<double> largest;
    std::vector<std::int64_t> sums;
    const std::vector<Ranks::Bytes>* outgoing = nullptr;
    std::vector<Ranks::Sent> sent;
  };

  class Member : public Ranks {
   public:
    Member(RankThreads& all, unsigned rank) : all_(all), rank_(rank) {}

    unsigned rank() const override { return rank_; }
    unsigned size() const override { return all_.size_; }
    bool deals_at_random() const override { return all_.at_random_; }
    std::vector<std::uint32_t> partition(const TileGraph& graph) override {
      return all_.partition_ ? all_.partition_(graph) : Ranks::partition(graph);
    }

    void broadcast(std::span<std::byte> data) override {
      own().broadcast = data;
      all_.meeting_.arrive_and_wait();
      if (rank_ > 0 && !data.empty()) std::memcpy(data.data(), all_.given_[0].broadcast.data(), data.size());
      all_.meeting_.arrive_and_wait();
    }

    void combine(std::span<double> largest, std::span<std::int64_t> sums) override {
      own().largest.assign(largest.begin(), largest.end());
      own().sums.assign(sums.begin(), sums.end());
      all_.meeting_.arrive_and_wait();
      std::fill(sums.begin(), sums.end(), 0);
      for (unsigned rank = size(); rank-- > 0;) {
        const Given& of = all_.given_[rank];
        for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], of.largest[k]);
        for (std::size_t k = 0; k < sums.size(); ++k)
          sums[k] = std::int64_t(std::uint64_t(sums[k]) + std::uint64_t(of.sums[k]));
      }
      all_.meeting_.arrive_and_wait();
    }

    std::vector<Bytes> exchange(const std::vector<Bytes>& outgoing) override {
      own().outgoing = &outgoing;
      all_.meeting_.arrive_and_wait();
      std::vector<Bytes> received;
      for (const Given& of : all_.given_) received.push_back((*of.outgoing)[rank_]);
      all_.meeting_.arrive_and_wait();
      return received;
    }

    // Messages are copied at the end alone, so that what is computed meanwhile sees none of them.
    void begin(std::span<const Sent> sent, std::span<const Received> received) override {
      own().sent.assign(sent.begin(), sent.end());
      received_.assign(received.begin(), received.end());
      for (const Received& message : received_)
        std::fill(message.numbers.begin(), message.numbers.end(), std::numeric_limits<double>::quiet_NaN());
    }

    void finish() override {
      all_.meeting_.arrive_and_wait();
      for (const Received& message : received_)
        for (const Sent& sent : all_.given_[message.from].sent)
          if (sent.to == rank_) std::copy(sent.numbers.begin(), sent.numbers.end(), message.numbers.begin());
      all_.meeting_.arrive_and_wait();
    }

   private:
    Given& own() { return all_.given_[rank_]; }

    RankThreads& all_;
    unsigned rank_;
    std::vector<Received> received_;
  };

  unsigned size_;
  bool at_random_;
  Partition partition_;
  std::barrier<> meeting_;
  std::vector<Given> given_;
};

}  // namespace scree::test
