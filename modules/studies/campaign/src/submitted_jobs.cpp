#include "submitted_jobs.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/content_hash.hpp>
#include <scree/files/text_file.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* jobs_name = "tasks/jobs.json";
constexpr std::string_view comment_begin = "scree tasks from ";

// The task of element 0 of an array of this program.
std::optional<std::size_t> first_of(const QueuedJob& job) {
  if (!job.element || !job.comment.starts_with(comment_begin)) return std::nullopt;
  std::size_t first = 0;
  const char* begin = job.comment.data() + comment_begin.size();
  if (std::from_chars(begin, job.comment.data() + job.comment.size(), first).ec != std::errc())
    return std::nullopt;
  return first;
}

// Whether any element has written what it prints, which it does before all else.
bool has_trace(const fs::path& folder, const std::string& job) {
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().filename().string().starts_with(job + "_")) return true;
  return false;
}

}  // namespace

SubmittedJobs::SubmittedJobs(const CampaignDirectory& directory) : directory_(directory) {
  std::error_code failed;
  const fs::path& path = directory.files().path();
  name_ = "scree-" + files::text_hash(fs::weakly_canonical(path, failed).string());
  if (!fs::exists(path / jobs_name, failed)) return;
  try {
    const Json json = Json::parse(files::read_text(path / jobs_name));
    name_ = json.at("name");
    for (const Json& entry : json.at("jobs"))
      entries_.push_back({entry.at("job"), entry.at("first"), entry.at("elements")});
  } catch (const Json::exception&) {
    throw Error((path / jobs_name).string(), "is no list of jobs",
                "cancel the jobs of the campaign, remove its folder tasks, and repeat the command");
  }
}

void SubmittedJobs::write() const {
  Json json = {{"version", SCREE_VERSION}, {"name", name_}, {"jobs", Json::array()}};
  for (const Entry& entry : entries_)
    json["jobs"].push_back({{"job", entry.job}, {"first", entry.first}, {"elements", entry.elements}});
  directory_.files().write_file(jobs_name, json.dump(1) + "\n");
}

std::string SubmittedJobs::comment_of(std::size_t first) { return fmt::format("{}{}", comment_begin, first); }

bool SubmittedJobs::adopt(const std::vector<QueuedJob>& queue) {
  const auto known = [&](const std::string& job) {
    return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.job == job; });
  };
  const bool any = known("");
  for (Entry& entry : entries_)
    for (const QueuedJob& job : queue)
      if (entry.job.empty() && first_of(job) == entry.first && !known(job.job)) entry.job = job.job;
  std::erase_if(entries_, [](const Entry& entry) { return entry.job.empty(); });
  return any;
}

std::string SubmittedJobs::submit(const Array& array, const std::vector<std::string>& words) {
  entries_.push_back({"", array.first, ranges_of(array.elements)});
  write();
  try {
    entries_.back().job = slurm::submit(words);
  } catch (const Error&) {
    entries_.pop_back();
    write();
    throw;
  }
  write();
  return entries_.back().job;
}

std::map<std::size_t, QueuedJob> SubmittedJobs::queued_tasks(const std::vector<QueuedJob>& queue) {
  std::map<std::size_t, QueuedJob> tasks;
  for (const QueuedJob& job : queue)
    if (const auto first = first_of(job)) tasks.insert_or_assign(*first + *job.element, job);
  return tasks;
}

std::map<std::size_t, std::string> SubmittedJobs::job_of_tasks() const {
  std::map<std::size_t, std::string> jobs;
  for (const Entry& entry : entries_)
    for (const std::size_t element : elements_of(entry.elements))
      jobs[entry.first + element] = fmt::format("{}_{}", entry.job, element);
  return jobs;
}

void SubmittedJobs::check_seen(const std::vector<QueuedJob>& queue) const {
  const fs::path folder = directory_.files().path() / CampaignDirectory::tasks_folder;
  if (entries_.empty()) return;
  const std::string& job = entries_.back().job;
  const bool waits =
      std::any_of(queue.begin(), queue.end(), [&](const QueuedJob& q) { return q.job == job; });
  if (waits || has_trace(folder, job)) return;
  const std::vector<std::string> states = slurm::states(job);
  if (std::find(states.begin(), states.end(), "FAILED") == states.end()) return;
  throw Error(
      directory_.files().path().string(),
      fmt::format("job {} has failed without writing there, as if its nodes did not see this directory", job),
      fmt::format("give an --out that they see, or remove {} and repeat the command", folder.string()));
}

}  // namespace scree::campaign
