#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <scree/campaign/report.hpp>
#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/report/page.hpp>

namespace scree::campaign {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string title_line(const Campaign& c) {
  std::vector<std::string> factors;
  if (!c.cases.empty()) factors.push_back(counted(c.cases.size(), "case"));
  for (const Parameter& p : c.parameters)
    factors.push_back(fmt::format("{} of {}", counted(p.values.size(), "value"), files::one_line(p.key)));
  if (!c.seeds.empty()) factors.push_back(counted(c.seeds.size(), "seed"));
  return fmt::format("{}: {}{}\n", files::one_line(c.title), counted(c.points.size(), "run"),
                     factors.empty() ? "" : fmt::format(", {}", fmt::join(factors, " x ")));
}

void write_expectations(const std::vector<Outcome>& outcomes, Out out) {
  struct Count {
    std::string requirement;
    std::size_t met = 0, of = 0;
  };
  std::vector<Count> counts;
  for (const Outcome& outcome : outcomes)
    for (const Outcome::Judged& judged : outcome.expectations) {
      const auto same = [&](const Count& c) { return c.requirement == judged.requirement; };
      auto at = std::find_if(counts.begin(), counts.end(), same);
      if (at == counts.end()) at = counts.insert(at, Count{judged.requirement, 0, 0});
      at->met += judged.met;
      ++at->of;
    }
  for (const Count& c : counts)
    fmt::format_to(out, "{:<8} in {} of {}: {}\n", c.met == c.of ? "met" : "NOT MET",
                   c.met == c.of ? c.met : c.of - c.met, c.of, files::one_line(c.requirement, 200));
}

constexpr std::size_t max_listed = 20;

// The name of a preparation, with its first case and its seed.
std::string name_of(const Point& preparation) {
  std::vector<std::string> of;
  if (!preparation.case_name.empty()) of.push_back(files::one_line(preparation.case_name));
  if (preparation.seed) of.push_back(fmt::format("seed {}", *preparation.seed));
  return of.empty() ? preparation.name : fmt::format("{} ({})", preparation.name, fmt::join(of, ", "));
}

void write_preparations(const Campaign& campaign, const Execution& execution, Out out) {
  const std::vector<Outcome>& outcomes = execution.preparations;
  std::size_t made = 0, kept = 0;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const std::string name = name_of(campaign.preparation->points[k]);
    const auto& prepared = execution.prepared;
    const bool now = std::find(prepared.begin(), prepared.end(), k) != prepared.end();
    if (outcomes[k].status == Status::failed)
      fmt::format_to(out, "FAILED   {}: {}\n", name, outcomes[k].problem);
    else if (now && ++made <= max_listed)
      fmt::format_to(out, "prepared {} in {:.3g} s\n", name, outcomes[k].number("wall_s"));
    else if (!now && outcomes[k].status == Status::finished)
      ++kept;
  }
  if (made > max_listed) fmt::format_to(out, "         and {} more\n", made - max_listed);
  if (kept) fmt::format_to(out, "kept     {} of an earlier call\n", counted(kept, "preparation"));
}

void write_resumed(const Execution& execution, Out out) {
  if (execution.gone_on)
    fmt::format_to(out, "{} went on from the state at which {} stopped\n", counted(execution.gone_on, "run"),
                   execution.gone_on == 1 ? "it" : "they");
  for (std::size_t k = 0; k < std::min(max_listed, execution.begun_anew.size()); ++k)
    fmt::format_to(out, "begun anew {}\n", execution.begun_anew[k]);
}

void write_failures(const Campaign& campaign, const std::vector<Outcome>& outcomes, Out out) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    if (outcomes[k].status == Status::failed && ++count <= max_listed)
      fmt::format_to(out, "FAILED   {}: {}\n", campaign.points[k].name, outcomes[k].problem);
  if (count > max_listed)
    fmt::format_to(out, "         and {} more, see campaign.json\n", count - max_listed);
}

void write_warnings(const Campaign& campaign, const std::vector<Outcome>& outcomes, const char* noun,
                    const char* where, Out out) {
  std::size_t count = 0, first = outcomes.size();
  for (std::size_t k = outcomes.size(); k-- > 0;)
    if (!outcomes[k].warnings.empty()) {
      first = k;
      ++count;
    }
  if (count)
    fmt::format_to(out, "WARNINGS in {} of {}, see {}; {}: {}\n", count, counted(outcomes.size(), noun),
                   where, campaign.points[first].name,
                   files::one_line(outcomes[first].warnings.front(), 200));
}

}  // namespace

std::string text_report(const Campaign& campaign, const Execution& execution) {
  std::string text = title_line(campaign);
  const Out out(text);
  write_preparations(campaign, execution, out);
  const std::size_t finished = execution.count(Status::finished), failed = execution.count(Status::failed);
  fmt::format_to(out, "{} finished", finished);
  if (execution.finished_before)
    fmt::format_to(out, " ({} of them in an earlier call)", execution.finished_before);
  if (failed) fmt::format_to(out, ", {} failed", failed);
  const std::size_t rest = execution.outcomes.size() - finished - failed;
  if (rest) fmt::format_to(out, ", {} to do", rest);
  fmt::format_to(out, "\n");
  write_resumed(execution, out);
  write_expectations(execution.preparations, out);
  write_expectations(execution.outcomes, out);
  write_failures(campaign, execution.outcomes, out);
  if (campaign.preparation)
    write_warnings(*campaign.preparation, execution.preparations, "preparation", "their run.json", out);
  write_warnings(campaign, execution.outcomes, "run", "the column warnings of table.csv", out);
  return text;
}

std::string list_report(const Campaign& campaign, const std::vector<Outcome>& preparations,
                        const std::vector<Outcome>& outcomes,
                        const std::map<std::string, std::string>& notes) {
  std::string text = title_line(campaign);
  const auto add = [&](const Outcome& outcome, const Point& point, const std::string& name) {
    const auto noted = notes.find(point.name);
    const bool plain = noted == notes.end() || noted->second.empty();
    text += fmt::format("{:<12} {}{}{}\n", status_name(outcome.status), name,
                        plain ? "" : fmt::format(" ({})", noted->second),
                        outcome.problem.empty() ? "" : fmt::format(": {}", outcome.problem));
  };
  for (std::size_t k = 0; k < preparations.size(); ++k)
    add(preparations[k], campaign.preparation->points[k], name_of(campaign.preparation->points[k]));
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    add(outcomes[k], campaign.points[k], campaign.points[k].name);
  return text;
}

std::string stopped_report(const Campaign& campaign, const std::vector<Outcome>& outcomes) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    if (outcomes[k].status != Status::failed && !outcomes[k].problem.empty() && ++count <= max_listed)
      text += fmt::format("stopped  {}: {}\n", campaign.points[k].name, outcomes[k].problem);
  if (count > max_listed)
    text += fmt::format("         and {} more, see campaign.json\n", count - max_listed);
  return text;
}

std::string leftover_report(const std::vector<std::string>& names) {
  constexpr std::size_t most_names = 5;
  if (names.empty()) return "";
  const std::vector<std::string> listed(names.begin(), names.begin() + std::min(most_names, names.size()));
  return fmt::format("{} with values no longer in the campaign, not in the tables: {}{}\n",
                     counted(names.size(), "run"),
                     files::one_line(fmt::format("{}", fmt::join(listed, "  ")), 400),
                     names.size() > most_names ? " ..." : "");
}

void write_report(const Campaign& campaign, const Execution& execution, const CampaignDirectory& directory) {
  const run::RunDirectory& files = directory.files();
  files.write_file("campaign.json", campaign_json(campaign, execution));
  files.write_file("table.csv", table_csv(campaign, execution.outcomes));
  std::error_code failed;
  if (campaign.seeds.size() > 1)
    files.write_file("means.csv", means_csv(campaign, execution.outcomes));
  else  // from an earlier version of the campaign
    std::filesystem::remove(files.path() / "means.csv", failed);
}

void write_page(const CampaignDirectory& directory) {
  const run::RunDirectory& files = directory.files();
  const std::filesystem::path file = files.path() / report::file_name;
  std::error_code failed;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, failed)) &&
      !report::is_page(files::read_text(file)))
    throw Error(file.string(), "is there and was not written by a campaign", "move it elsewhere");
  files.write_file(report::file_name, report::page_of(files.path()));
}

}  // namespace scree::campaign
