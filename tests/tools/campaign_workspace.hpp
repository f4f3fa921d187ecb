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

inline const std::string call = "campaign campaign.toml --out out ";

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace scree::test
