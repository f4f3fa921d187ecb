#include "record_json.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/campaign/campaign_directory.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>

namespace scree::campaign {

namespace fs = std::filesystem;

namespace {

// Two campaigns in one directory would replace each other's runs.
void check_owner(const fs::path& path, const Campaign& campaign) {
  std::error_code failed;
  const fs::path record = path / "campaign.json";
  if (!fs::exists(record, failed)) return;
  if (!fs::is_regular_file(record, failed))
    throw Error(fmt::format("{}: is not a file; remove it, or give another --out", record.string()));
  const auto json = parse_record(files::read_text(record));
  if (!json.is_object() || !json.contains("file") || !json["file"].is_string()) return;
  const std::string owner = json["file"];
  // Campaign file and directory may have been moved together.
  const bool elsewhere = fs::exists(owner, failed) && !fs::equivalent(owner, campaign.source, failed);
  if (elsewhere || fs::path(owner).filename() != campaign.source.filename())
    throw Error(fmt::format("{}: contains the campaign of {}; give another --out", path.string(),
                            files::one_line(owner)));
}

Error in_use(const fs::path& path) {
  return Error(
      fmt::format("{}: another campaign is running there; wait for it or give another --out", path.string()));
}

}  // namespace

CampaignDirectory::CampaignDirectory(fs::path path, const Campaign& campaign, bool alone)
    : files_(std::move(path), true, run::RunDirectory::Kind::campaign) {
  check_owner(files_.path(), campaign);
  in_use_ = !lock();
  if (alone && in_use_) throw in_use(files_.path());
}

CampaignDirectory::~CampaignDirectory() {
  if (lock_ >= 0) close(lock_);
}

bool CampaignDirectory::lock() {
  lock_ = open(files_.path().c_str(), O_RDONLY | O_DIRECTORY);
  return lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void CampaignDirectory::create() {
  files_.create();
  if (lock_ < 0 && !lock()) throw in_use(files_.path());
}

std::vector<Outcome> CampaignDirectory::outcomes(const Campaign& campaign) const {
  std::vector<Outcome> all;
  for (const Point& point : campaign.points) all.push_back(outcome(campaign, point));
  return all;
}

Outcome CampaignDirectory::outcome(const Campaign& campaign, const Point& point) const {
  Outcome found = read_outcome(run(point), inputs_of(campaign, point), campaign.collect);
  if (found.state == State::running && !in_use_) found.state = State::interrupted;
  return found;
}

std::vector<std::string> CampaignDirectory::leftovers(const Campaign& campaign) const {
  std::vector<std::string> names;
  std::error_code failed;  // an unreadable directory has no leftovers
  for (const auto& entry : fs::directory_iterator(files_.path(), failed)) {
    const std::string name = entry.path().filename().string();
    const auto is_there = [&](const Point& point) { return point.name == name; };
    const bool begun = fs::exists(entry.path() / run::RunDirectory::log_name, failed) ||
                       fs::exists(entry.path() / "run.json", failed);
    if (begun && std::none_of(campaign.points.begin(), campaign.points.end(), is_there))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace scree::campaign
