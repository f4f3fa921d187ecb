#include "campaign_charts.hpp"
#include "common_sections.hpp"
#include "html.hpp"
#include "numbers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/counted.hpp>
#include <scree/report/page.hpp>
#include <scree/report/record.hpp>

// The page of a campaign.
namespace scree::report {

namespace {

std::string status_line(const Json& record) {
  std::map<std::string, std::size_t> counts;
  for (const Json& run : list_in(record, "runs")) ++counts[text_in(run, "status")];
  const std::size_t all = list_in(record, "runs").size(), finished = counts["finished"],
                    failed = counts["failed"];
  if (finished == all)
    return mark("good",
                all == 1 ? "Its run finished." : fmt::format("All {} finished.", counted(all, "run")));
  std::string text = fmt::format("{} of {} finished", finished, counted(all, "run"));
  if (failed) text += fmt::format(", {} failed", failed);
  if (const std::size_t rest = all - finished - failed) text += fmt::format(", {} to do", rest);
  return mark(failed ? "bad" : "open", text + ".");
}

std::string expectation_line(const TextTable& table) {
  std::size_t with_any = 0, unmet = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double all = table.number(row, "expectations"), met = table.number(row, "expectations_met");
    if (!(all > 0)) continue;
    ++with_any;
    unmet += met < all;
  }
  if (with_any == 0) return "";
  if (unmet == 0) return mark("good", "All expectations are met in all runs that finished.");
  return mark("bad", fmt::format("In {} of {} expectations are not met.", unmet, counted(with_any, "run")));
}

// A quantity in a unit that suits its largest mean.
struct Column {
  std::string quantity;
  charts::ScaledUnit unit;
};

std::vector<Column> columns_of(const CampaignTable& table) {
  std::vector<Column> columns;
  for (const std::string& quantity : table.quantities()) {
    double largest = 0;
    for (const Combination& combination : table.combinations())
      largest = std::fmax(largest, std::abs(table.mean(combination, quantity).mean));
    columns.push_back({quantity, charts::scaled_unit(largest, table.unit(quantity))});
  }
  return columns;
}

std::string means(const CampaignTable& table, bool has_seeds) {
  const std::vector<Column> columns = columns_of(table);
  std::vector<Heading> headings;
  for (std::size_t k = 0; k < table.keys().size(); ++k)
    headings.push_back({table.short_name(k), table.is_numeric(k)});
  headings.push_back({"runs", true});
  for (const Column& column : columns)
    headings.push_back({column.unit.symbol.empty()
                            ? column.quantity
                            : fmt::format("{} ({})", column.quantity, column.unit.symbol),
                        true});
  Table html(headings);
  for (const Combination& combination : table.combinations()) {
    std::vector<std::string> cells;
    for (const std::string& value : combination.values) cells.push_back(escaped(value));
    cells.push_back(count_text(double(combination.rows.size())));
    for (const Column& column : columns) {
      const Mean mean = table.mean(combination, column.quantity);
      cells.push_back(with_error(column.unit.factor * mean.mean, column.unit.factor * mean.standard_error));
    }
    html.add(std::move(cells));
  }
  return section(has_seeds ? "Means over the seeds, with standard errors" : "Results",
                 html.html(has_seeds ? "means.csv" : "table.csv"));
}

// The name of a run, as a link where it has a page.
std::string link_to(const Results& results, const std::string& run) {
  std::error_code failed;
  if (!std::filesystem::exists(results.directory / run / file_name, failed)) return escaped(run);
  return fmt::format("<a href=\"{}/{}\">{}</a>", address(run), file_name, escaped(run));
}

std::string runs(const Results& results, const TextTable& table) {
  std::map<std::string, std::string> errors;
  for (const Json& run : list_in(results.record, "runs")) errors[text_in(run, "run")] = text_in(run, "error");
  Table html({{"run"}, {"status"}, {"expectations met", true}, {"wall time", true}, {"remarks"}});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "run");
    const double expected = table.number(row, "expectations"), wall_time = table.number(row, "wall_s");
    const std::string& warnings = table.text(row, "warnings");
    html.add(
        {link_to(results, name), escaped(table.text(row, "status")),
         expected > 0 ? fmt::format("{:.0f} of {:.0f}", table.number(row, "expectations_met"), expected) : "",
         std::isnan(wall_time) ? "" : duration_text(wall_time),
         escaped(errors[name].empty() ? warnings : errors[name])});
  }
  return section("Runs", folded("Each run, with its page", html.html("table.csv")));
}

std::string settings_text(const Json& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string repetition_of(const Results& results) {
  const Json& record = results.record;
  Facts facts;
  facts.add("command", code(fmt::format("scree campaign {}", text_in(record, "file"))));
  facts.add("program", program_of(results));
  facts.add("scenario", code(text_in(record, "scenario")));
  std::string seeds;
  for (const Json& seed : list_in(record, "seeds"))
    if (seeds.size() < 200) seeds += (seeds.empty() ? "" : ", ") + settings_text(seed);
  facts.add("seeds", escaped(seeds));
  for (const auto& [key, value] : object_in(record, "fixed").items())
    facts.add(key, code(settings_text(value)));
  return section("How to repeat it",
                 facts.html() + paragraph("The page of each run has its hashes and its scenario."));
}

}  // namespace

std::string campaign_sections(const Results& results) {
  const CampaignTable table(results);
  Figures figures;
  add_campaign_charts(table, figures);
  const bool has_seeds = list_in(results.record, "seeds").size() > 1;
  return status_line(results.record) + expectation_line(table.table()) + section("Charts", figures.html()) +
         means(table, has_seeds) + verdicts_of_cycles(results) + runs(results, table.table()) +
         repetition_of(results);
}

}  // namespace scree::report
