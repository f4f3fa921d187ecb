#pragma once

#include "support/verbs.hpp"

#include <functional>

#include <scree/ranks.hpp>

namespace scree::tool {

// Adds --ranks.
void add_ranks_option(Verb& verb, bool& over_ranks);

// What a process that computes a scene over ranks needs besides the work itself.
struct OverRanks {
  bool asked = false;  // --ranks
  unsigned threads = 1;
  const PluginOptions& plugins;
};

// Whether the program was started several times by mpirun or srun for a verb that writes files, and without
// --ranks. Writes a line about it.
bool refuses_tasks(int argc, char** argv);

// Does the work of a verb: with --ranks on the first of the processes that mpirun or srun has started, while
// the others follow it and return success; else without ranks (null). Throws Error if the processes
// do not find each other.
ExitStatus do_over_ranks(const OverRanks& options, const std::function<ExitStatus(Ranks*)>& work);

}  // namespace scree::tool
