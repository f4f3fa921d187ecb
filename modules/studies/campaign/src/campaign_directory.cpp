#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/campaign/campaign_directory.hpp>
#include <scree/files/directory_lock.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/result_kind.hpp>

namespace scree::campaign {

namespace fs = std::filesystem;

namespace {

constexpr const char* state_of_spectrum = "state.h5";  // from which a spectrum goes on
constexpr const char* state_path = "SCREE_STATE_PATH";

// Two campaigns in one directory would replace each other's runs.
void check_owner(const fs::path& path, const Campaign& campaign) {
  std::error_code failed;
  const fs::path record = path / "campaign.json";
  if (!fs::exists(record, failed)) return;
  if (!fs::is_regular_file(record, failed))
    throw Error(record.string(), "is not a file", "remove it, or give another --out");
  const auto json = run::parse_record(files::read_text(record));
  if (!json.is_object() || !json.contains("file") || !json["file"].is_string()) return;
  const std::string owner = json["file"];
  // Campaign file and directory may have been moved together.
  const bool elsewhere = fs::exists(owner, failed) && !fs::equivalent(owner, campaign.source, failed);
  if (elsewhere || fs::path(owner).filename() != campaign.source.filename())
    throw Error(path.string(), fmt::format("contains the campaign of {}", files::one_line(owner)),
                "give another --out");
}

}  // namespace

StatePath::StatePath(const std::filesystem::path& folder) {
  if (folder.string().find(':') != std::string::npos)
    throw Error(folder.parent_path().string(), "the path of a campaign with [prepare] cannot contain ':'",
                "give another --out");
  if (const char* before = std::getenv(state_path)) before_ = before;
  setenv(state_path, (folder.string() + (before_ ? ":" + *before_ : "")).c_str(), 1);
}

StatePath::~StatePath() { before_ ? setenv(state_path, before_->c_str(), 1) : unsetenv(state_path); }

CampaignDirectory::CampaignDirectory(fs::path path, const Campaign& campaign, bool alone)
    : files_(std::move(path), run::RunDirectory::Existing::keep, run::RunDirectory::Kind::campaign) {
  if (alone) files_.take();
  check_owner(files_.path(), campaign);
  if (campaign.preparation) states_.emplace(files_.path() / preparation_folder);
}

std::vector<Outcome> CampaignDirectory::preparations(const Campaign& campaign, const PluginHost& host) const {
  return campaign.preparation ? outcomes(*campaign.preparation, host) : std::vector<Outcome>();
}

std::vector<Outcome> CampaignDirectory::outcomes(const Campaign& campaign, const PluginHost& host) const {
  std::vector<Outcome> all;
  // One that goes on removes the final state of a stop between its state and its record.
  const std::vector<Outcome> made = preparations(campaign, host);
  for (std::size_t k = 0; k < campaign.points.size(); ++k) {
    const Point& point = campaign.points[k];
    std::error_code failed;
    const bool prepared =
        !campaign.preparation || made[campaign.preparation_of[k]].status == Status::finished;
    if (prepared)
      all.push_back(outcome(campaign, point, host));
    else  // its inputs are not known yet
      all.emplace_back().status =
          fs::exists(run(point) / campaign.record(), failed) ? Status::changed : Status::missing;
  }
  return all;
}

Outcome CampaignDirectory::outcome(const Campaign& campaign, const Point& point,
                                   const PluginHost& host) const {
  Outcome found = read_outcome(run(point), campaign, inputs_of(campaign, point, host));
  if (found.status == Status::running && !is_written(point)) found.status = Status::interrupted;
  const bool prepares = fs::path(point.name).parent_path() == preparation_folder;
  if (prepares && found.status == Status::finished && !has_final_state(point)) found.status = Status::changed;
  return found;
}

bool CampaignDirectory::is_written(const Point& point) const {
  return files::DirectoryLock::is_held(run(point));
}

bool CampaignDirectory::has_final_state(const Point& point) const {
  std::error_code failed;
  return fs::is_regular_file(run(point) / final_state, failed);
}

bool CampaignDirectory::has_state(const Point& point) const {
  std::error_code failed;
  if (fs::exists(run(point) / state_of_spectrum, failed)) return true;
  for (const auto& entry : fs::directory_iterator(run(point) / "checkpoint", failed))
    if (entry.path().extension() == ".h5") return true;
  return false;
}

std::vector<std::string> CampaignDirectory::leftovers(const Campaign& campaign) const {
  std::vector<std::string> names;
  std::error_code failed;  // an unreadable directory has no leftovers
  for (const auto& entry : fs::directory_iterator(files_.path(), failed)) {
    const std::string name = entry.path().filename().string();
    const auto is_there = [&](const Point& point) { return point.name == name; };
    const bool begun = fs::exists(entry.path() / run::RunDirectory::log_name, failed) ||
                       fs::exists(entry.path() / campaign.record(), failed);
    if (begun && std::none_of(campaign.points.begin(), campaign.points.end(), is_there))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace scree::campaign
