#pragma once

#include "plan_support.hpp"

#include <string>
#include <vector>

#include <scree/campaign/campaign.hpp>
#include <scree/campaign/outcome.hpp>
#include <scree/run/run.hpp>

namespace scree::test {

// A temporary folder with scene.toml and a campaign.toml for this scene.
class CampaignFolder {
 public:
  explicit CampaignFolder(const std::string& rest, const std::string& scene = discs) {
    folder_.write("scene.toml", scene);
    folder_.write("campaign.toml", "[campaign]\nscenario = 'scene.toml'\n" + rest);
  }
  campaign::Campaign read(const std::vector<std::string>& overrides = {}) const {
    return campaign::read_campaign(folder_ / "campaign.toml", overrides);
  }
  const TemporaryFolder& folder() const { return folder_; }

  // Error message for the campaign or its first refused run, without the path of the folder.
  std::string refusal(const std::vector<std::string>& overrides = {}) const {
    std::string line = message([&] {
      const campaign::Campaign read_in = read(overrides);
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

inline campaign::Outcome finished(std::vector<std::pair<std::string, double>> numbers, bool met = true) {
  return {campaign::Status::finished, "", std::move(numbers), {{"It holds", met}}};
}

using Texts = std::vector<std::string>;

inline std::string refusal_of(const std::string& rest) { return CampaignFolder(rest).refusal(); }

inline bool starts(const std::string& line, const std::string& with) {
  INFO(line);
  CHECK(line.starts_with(with));
  return line.starts_with(with);
}

inline std::vector<std::string> names_of(const campaign::Campaign& campaign) {
  std::vector<std::string> names;
  for (const campaign::Point& point : campaign.points) names.push_back(point.name);
  return names;
}

// Runs a point.
inline void make_run(const campaign::Campaign& c, std::size_t k, const std::filesystem::path& out) {
  run::RunOptions options;
  options.out = out;
  options.overwrite = true;
  run::run_plan(scenario::read_plan(c.scenario, c.points[k].overrides(), host()), options);
}

inline campaign::Outcome outcome_of(const campaign::Campaign& c, std::size_t k,
                                    const std::filesystem::path& out, const PluginHost& plugins = host()) {
  return campaign::read_outcome(out, c, campaign::inputs_of(c, c.points[k], plugins));
}

}  // namespace scree::test
