#include <algorithm>

#include <nlohmann/json.hpp>

#include <scree/campaign/tasks.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/result_kind.hpp>

namespace scree::campaign {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* list_name = "tasks/tasks.json";

}  // namespace

TaskList::TaskList(const CampaignDirectory& directory) {
  const std::filesystem::path path = directory.files().path() / list_name;
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return;
  try {
    const Json json = Json::parse(files::read_text(path));
    for (const Json& task : json.at("tasks")) add({task.at("runs"), task.at("inputs")});
  } catch (const Json::exception&) {
    throw Error(path.string(), "is no list of tasks",
                "cancel the jobs of the campaign, remove its folder tasks, and repeat the command");
  }
}

std::size_t TaskList::number_of(const Campaign& campaign, const std::vector<const Point*>& points,
                                const PluginHost& host) {
  Task task;
  for (const Point* point : points) {
    task.runs.push_back(point->name);
    task.inputs.push_back(inputs_key(campaign, *point, host));
  }
  return add(std::move(task));
}

std::size_t TaskList::add(Task task) {
  const auto [known, is_new] = numbers_.try_emplace({task.runs, task.inputs}, tasks_.size());
  if (is_new) tasks_.push_back(std::move(task));
  return known->second;
}

void TaskList::write(const CampaignDirectory& directory) const {
  Json json = {{"version", SCREE_VERSION}, {"tasks", Json::array()}};
  for (const Task& task : tasks_) json["tasks"].push_back({{"runs", task.runs}, {"inputs", task.inputs}});
  directory.files().write_file(list_name, json.dump(0) + "\n");
}

TaskNumbers list_tasks(const Campaign& campaign, const CampaignDirectory& directory, std::size_t per_task,
                       const std::function<bool(const Point&)>& wanted, const PluginHost& host) {
  TaskList list(directory);
  TaskNumbers numbers;
  std::vector<std::vector<const Point*>> points(campaign.preparation ? campaign.preparation->points.size()
                                                                     : 1);
  if (campaign.preparation)
    for (const Point& point : campaign.preparation->points)
      if (wanted(point))
        numbers.preparations.push_back(list.number_of(*campaign.preparation, {&point}, host));
  for (std::size_t k = 0; k < campaign.points.size(); ++k)
    if (wanted(campaign.points[k]))
      points[campaign.preparation ? campaign.preparation_of[k] : 0].push_back(&campaign.points[k]);
  for (const std::vector<const Point*>& all : points) {
    std::vector<std::size_t>& of = numbers.points.emplace_back();
    for (auto first = all.begin(); first != all.end();) {
      const auto end = first + std::min<std::ptrdiff_t>(std::ptrdiff_t(per_task), all.end() - first);
      of.push_back(list.number_of(campaign, {first, end}, host));
      first = end;
    }
  }
  list.write(directory);
  return numbers;
}

std::string shell_line(const std::vector<std::string>& words) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace scree::campaign
