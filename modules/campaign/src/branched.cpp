#include "directory_layout.hpp"

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/files/content_hash.hpp>

namespace scree::campaign {

namespace {

// Another preparation has another directory, so that a state never changes under the runs that began from it.
std::string key_of(const Inputs& inputs) {
  std::string all = inputs.resolved_text + '\0' + inputs.hashes.bodies;
  for (const auto& [name, hash] : inputs.hashes.plugins) all += '\0' + name + '\0' + hash;
  return files::text_hash(all);
}

}  // namespace

Campaign branched(Campaign campaign, const PluginHost& host) {
  if (!campaign.preparation) return campaign;
  const auto preparation = std::make_shared<Campaign>(*campaign.preparation);
  std::vector<std::string> states;  // as in SCREE_STATE_PATH
  for (Point& point : preparation->points) {
    const std::string key = key_of(inputs_of(*preparation, point, host));
    point.name = fmt::format("{}/{}", preparation_folder, key);
    states.push_back(fmt::format("\"{}/{}\"", key, final_state));
  }
  campaign.preparation = preparation;
  for (std::size_t k = 0; k < campaign.points.size(); ++k)
    campaign.points[k].settings.push_back(
        {"particles.state", states[campaign.preparation_of(k)], campaign.scenario_place});
  return campaign;
}

}  // namespace scree::campaign
