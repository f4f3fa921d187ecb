#include "job.hpp"

#include <fmt/format.h>

#include <scree/campaign/gather.hpp>

namespace scree::campaign {

namespace {

// A run that was refused leaves only a log, and has failed.
void add_log(const Point& point, const CampaignDirectory& directory, Outcome& outcome) {
  std::error_code failed;
  const bool ended = outcome.status == Status::missing || outcome.status == Status::interrupted;
  if (!ended || directory.is_written(point) || !std::filesystem::exists(directory.log(point), failed)) return;
  if (outcome.status == Status::missing && !reported_in(directory.log(point)).empty())
    outcome.status = Status::failed;
  outcome.problem = directory.has_state(point) ? "its state is saved" : problem_of(directory.log(point), "");
}

}  // namespace

Execution gathered(const Campaign& campaign, const CampaignDirectory& directory, const PluginHost& host) {
  Execution result;
  result.preparations = directory.preparations(campaign, host);
  result.outcomes = directory.outcomes(campaign, host);
  for (std::size_t k = 0; k < result.preparations.size(); ++k)
    add_log(campaign.preparation->points[k], directory, result.preparations[k]);
  for (std::size_t k = 0; k < result.outcomes.size(); ++k) {
    Outcome& outcome = result.outcomes[k];
    add_log(campaign.points[k], directory, outcome);
    if (!campaign.preparation) continue;
    const std::size_t from = campaign.preparation_of[k];
    if (result.preparations[from].status != Status::failed) continue;
    outcome = {};
    outcome.status = Status::failed;
    outcome.problem = failed_with(campaign.preparation->points[from], result.preparations[from]);
  }
  for (const auto* all : {&result.preparations, &result.outcomes})
    for (const Outcome& outcome : *all) result.blew_up |= outcome.blew_up;
  return result;
}

}  // namespace scree::campaign
