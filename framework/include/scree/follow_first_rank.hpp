#pragma once

#include <functional>

#include <scree/plugin_host.hpp>
#include <scree/ranks.hpp>

namespace scree {

// On the first rank: as long as this lives, the others follow. It outlives its simulations.
class FirstRank {
 public:
  // Null: there are no others.
  explicit FirstRank(Ranks* ranks) : ranks_(ranks) {}
  ~FirstRank();
  FirstRank(const FirstRank&) = delete;
  FirstRank& operator=(const FirstRank&) = delete;

 private:
  Ranks* ranks_;
};

// On each other rank: computes its share of every simulation that the first rank makes over these ranks, as
// long as the first rank leads.
// is_interrupted: whether this process has been asked to stop, of which the first rank is told; may be empty.
// Throws what only this rank fails with.
void follow_first_rank(Ranks& ranks, PluginHost& host, unsigned threads,
                       const std::function<bool()>& is_interrupted = {});

}  // namespace scree
