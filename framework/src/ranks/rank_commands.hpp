#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <scree/ranks.hpp>

namespace scree {

// What the first rank has the other ranks do with it; see follow_first_rank().
enum class RankCommand : std::uint64_t {
  begin,  // a simulation
  find_and_evaluate_pairs,
  step_observed,
  step_followed,
  step_by_substeps,
  go_on,  // after a substep
  gather_bodies,
  gather_listed,
  gather_pairs,
  gather_sliding_work,
  sum_energies,
  count_pairs,
  add_histories,
  add_totals,  // of a probe
  change_law,
  change_boundary,
  change_body_force,
  apply_changes,
  end,   // of the simulation
  leave  // follow_first_rank()
};

struct ReceivedCommand {
  RankCommand command;
  std::vector<std::string> lines;
};

// By the first rank: gives all others a command, with lines of text.
void send_command(Ranks& ranks, RankCommand command, const std::vector<std::string>& lines = {});
// By each other rank: waits for the next command.
ReceivedCommand receive_command(Ranks& ranks);

}  // namespace scree
