#include <algorithm>

#include <scree/campaign/campaign.hpp>

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

}  // namespace scree::campaign
