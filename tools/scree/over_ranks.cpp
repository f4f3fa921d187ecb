#include "over_ranks.hpp"

#include <memory>

#include <scree/error.hpp>
#include <scree/follow_first_rank.hpp>
#include <scree/ranks/join_ranks.hpp>
#include <scree/ranks/launcher.hpp>

namespace scree::tool {

void add_ranks_option(Verb& verb, bool& over_ranks) {
  verb.flag("--ranks", over_ranks,
            "One scene over the processes that mpirun or srun has started; results have the same bits");
}

ExitStatus do_over_ranks(const OverRanks& options, const std::function<ExitStatus(Ranks*)>& work) {
  if (!options.asked) {
    if (!ranks::is_one_of_several_tasks()) return work(nullptr);
    if (!ranks::is_first_task()) return ExitStatus::bad_input;
    throw Error(
        "the program was started several times by mpirun or srun; give --ranks to compute one scene together");
  }
  const std::unique_ptr<Ranks> all = ranks::join_ranks();
  if (all->rank() == 0) {
    const FirstRank leads(all.get());
    return work(all.get());
  }
  const std::atomic<bool>& interrupted = watch_for_interrupt();
  PluginHost host = make_host(options.plugins);
  follow_first_rank(*all, host, options.threads, [&] { return interrupted.load(); });
  return ExitStatus::success;
}

}  // namespace scree::tool
