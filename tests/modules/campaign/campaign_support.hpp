#pragma once

#include "plan_support.hpp"

#include <string>
#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::test {

// A temporary folder with scene.toml and a campaign.toml for this scene.
class CampaignFolder {
 public:
  explicit CampaignFolder(const std::string& rest, const std::string& scene = discs) {
    folder_.write("scene.toml", scene);
    folder_.write("campaign.toml", "[campaign]\nscenario = 'scene.toml'\n" + rest);
  }
  campaign::Campaign read() const { return campaign::read_campaign(folder_ / "campaign.toml"); }
  const TemporaryFolder& folder() const { return folder_; }

  // Error message for the campaign or its first refused run, without the path of the folder.
  std::string refusal() const {
    std::string line = message([&] {
      const campaign::Campaign read_in = read();
      for (const campaign::Point& point : read_in.points) {
        campaign::inputs_of(read_in, point, host());
        campaign::check_point(read_in, point, host());
      }
    });
    const std::string prefix = folder_.path().string() + "/";
    for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
      line.erase(at, prefix.size());
    return line;
  }

 private:
  TemporaryFolder folder_;
};

inline std::vector<std::string> names_of(const campaign::Campaign& campaign) {
  std::vector<std::string> names;
  for (const campaign::Point& point : campaign.points) names.push_back(point.name);
  return names;
}

}  // namespace scree::test
