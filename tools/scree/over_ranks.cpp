#include "over_ranks.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <scree/error.hpp>
#include <scree/follow_first_rank.hpp>
#include <scree/ranks/join_ranks.hpp>
#include <scree/ranks/launcher.hpp>

namespace scree::tool {

void add_ranks_option(Verb& verb, bool& over_ranks) {
  verb.flag("--ranks", over_ranks,
            "One scene over the processes that mpirun or srun has started; results have the same bits");
}

bool refuses_tasks(int argc, char** argv) {
  constexpr std::string_view writing[] = {"run",   "resume",       "bench",    "campaign", "spectrum",
                                          "modes", "quasi-static", "accuracy", "cycles"};
  const std::vector<std::string_view> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() || std::find(std::begin(writing), std::end(writing), words[0]) == std::end(writing))
    return false;
  const bool asked = std::find(words.begin(), words.end(), "--ranks") != words.end();
  if (!ranks::is_one_of_several_tasks()) return false;
  if (asked && words[0] != "campaign") {
    print_reports(ranks::is_first_task());  // all would say the same of the command line
    return false;
  }
  if (ranks::is_first_task())
    report(
        "the program was started several times by mpirun or srun; give --ranks to run, resume or bench one "
        "scene together, or start it once",
        ExitStatus::bad_input);
  return true;
}

namespace {

// The plug-ins of this rank; null if some rank cannot load them. Throws Error on the first such rank.
std::unique_ptr<PluginHost> host_of_rank(Ranks& all, const PluginOptions& options) {
  std::unique_ptr<PluginHost> host;
  std::optional<Error> problem;
  try {
    host.reset(new PluginHost(make_host(options)));
  } catch (const Error& error) {
    problem = error;
  }
  const double own = problem ? double(all.size() - all.rank()) : 0;
  double first = own;
  all.combine({&first, 1}, {});
  if (first > 0 && first == own) throw *problem;
  return first > 0 ? nullptr : std::move(host);
}

}  // namespace

ExitStatus do_over_ranks(const OverRanks& options, const std::function<ExitStatus(Ranks*)>& work) {
  if (!options.asked) return work(nullptr);
  const std::atomic<bool>& interrupted = watch_for_interrupt();  // before mpirun passes signals on
  print_reports(true);
  const std::unique_ptr<Ranks> all = ranks::join_ranks();
  if (all->size() == 1 && ranks::is_one_of_several_tasks()) {
    if (!ranks::is_first_task()) return ExitStatus::bad_input;
    throw Error(
        "the processes that mpirun or srun has started do not find each other; use mpirun of the MPI with which "
        "the program was built (modules/README.md), or srun --mpi=pmix");
  }
  const std::unique_ptr<PluginHost> host = host_of_rank(*all, options.plugins);
  if (!host) return ExitStatus::bad_input;
  if (all->rank() == 0) {
    const FirstRank leads(all.get());
    return work(all.get());
  }
  follow_first_rank(*all, *host, options.threads, [&] { return interrupted.load(); });
  return ExitStatus::success;
}

}  // namespace scree::tool
