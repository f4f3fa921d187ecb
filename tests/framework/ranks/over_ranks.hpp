#pragma once

#include "rank_threads.hpp"
#include "scenes.hpp"

#include <functional>

#include <scree/follow_first_rank.hpp>

namespace scree::test {

// Does work on the first of some ranks, while the others follow. at_random: tiles are dealt to ranks anew
// after each search. partition: see RankThreads.
inline void over_ranks(unsigned ranks, bool at_random, const std::function<void(Ranks&)>& work,
                       const RankThreads::Partition& partition = {}) {
  host();  // is loaded before threads ask for it
  RankThreads(ranks, at_random, partition).run([&](Ranks& member) {
    if (member.rank() > 0) {
      PluginHost plugins({SCREE_TEST_PLUGINS, SCREE_TEST_LAWS});
      return follow_first_rank(member, plugins, 1);
    }
    const FirstRank leads(&member);
    work(member);
  });
}

}  // namespace scree::test
