#include <algorithm>

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/campaign/campaign_directory.hpp>

namespace scree::campaign {

std::vector<std::string> Point::overrides() const {
  std::vector<std::string> texts;
  for (const Setting& setting : settings) texts.push_back(setting.key + "=" + setting.value);
  return texts;
}

const Setting* Point::find(const std::string& key) const {
  const auto found =
      std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; });
  return found == settings.end() ? nullptr : &*found;
}

std::vector<std::string> Campaign::varying_keys() const {
  std::vector<std::string> keys;
  for (const Case& one : cases)
    for (const Setting& setting : one.settings)
      if (std::find(keys.begin(), keys.end(), setting.key) == keys.end()) keys.push_back(setting.key);
  for (const Parameter& parameter : parameters) keys.push_back(parameter.key);
  return keys;
}

Campaign branched(Campaign campaign, const PluginHost& host) {
  if (!campaign.preparation) return campaign;
  const auto preparation = std::make_shared<Campaign>(*campaign.preparation);
  std::vector<Point> all = std::move(preparation->points);
  preparation->points.clear();
  // Another preparation has another directory, so that a state never changes under the runs that began from
  // it.
  std::vector<std::string> keys;      // of preparation->points
  std::vector<std::size_t> place_of;  // of all: cases that prepare alike share a preparation
  for (Point& point : all) {
    const std::string key = inputs_key(*preparation, point, host);
    const auto known = std::find(keys.begin(), keys.end(), key);
    place_of.push_back(std::size_t(known - keys.begin()));
    if (known != keys.end()) continue;
    keys.push_back(key);
    point.name = fmt::format("{}/{}", CampaignDirectory::preparation_folder, key);
    preparation->points.push_back(std::move(point));
  }
  campaign.preparation = preparation;
  for (std::size_t k = 0; k < campaign.points.size(); ++k) {
    std::size_t& place = campaign.preparation_of[k];
    place = place_of[place];
    const std::string path =
        fmt::format("\"{}/{}\"", keys[place], CampaignDirectory::final_state);  // as in SCREE_STATE_PATH
    campaign.points[k].settings.push_back({campaign.state_key, path, campaign.scenario_place});
  }
  return campaign;
}

}  // namespace scree::campaign
