#pragma once

#include "program.hpp"

#include <string>

namespace scree::test {

// A folder with scene.toml and a campaign file.
struct CampaignWorkspace : Workspace {
  explicit CampaignWorkspace(const std::string& rest, const std::string& scene = discs) : Workspace(scene) {
    write("campaign.toml", "[campaign]\nscenario = 'scene.toml'\n" + rest);
  }
};

inline const std::string campaign_call = "campaign campaign.toml --out out ";

}  // namespace scree::test
