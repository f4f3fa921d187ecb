#include "common_sections.hpp"
#include "html.hpp"
#include "numbers.hpp"
#include "scene_charts.hpp"
#include "scene_facts.hpp"
#include "scene_pictures.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/report/record.hpp>
#include <scree/report/result_tables.hpp>

// The page of a run.
namespace scree::report {

namespace {

const char* end_in_words(const std::string& ended) {
  if (ended == "duration") return "after its duration";
  if (ended == "condition") return "by its condition";
  if (ended == "at_most") return "at its longest duration, condition not met";
  if (ended == "interrupted") return "interrupted";
  if (ended == "failed") return "failed";
  return "not yet";
}

std::string stages(const Json& record) {
  Table table({{"stage"}, {"from", true}, {"to", true}, {"lasted", true}, {"steps", true}, {"ended"}});
  for (const Json& stage : list_in(record, "stages")) {
    const double start = number_in(stage, "start"), end = number_in(stage, "end");
    table.add({escaped(text_in(stage, "name")), with_unit(start, "s"), with_unit(end, "s"),
               with_unit(end - start, "s"), count_text(number_in(stage, "steps")),
               end_in_words(text_in(stage, "ended"))});
  }
  return section("Stages", table.html("run.json"));
}

std::string balances(const Json& record) {
  Table table({{"balance"}, {"value", true}, {"meaning"}});
  const auto add = [&](const char* key, const char* name, const char* meaning, double scale = 1,
                       const char* unit = "") {
    if (const double value = number_in(record, key); !std::isnan(value))
      table.add({name, number_text(scale * value, 3) + unit, meaning});
  };
  add("energy_residual", "energy residual",
      "energy that no reservoir or sink accounts for, over the energy turned over");
  add("energy_created", "energy created", "energy that a law created, over the energy turned over");
  add("momentum_residual", "momentum residual",
      "momentum that no force accounts for, over the momentum turned over");
  add("max_overlap_ratio", "largest overlap",
      "of the radius of the smaller body: whether the stiffness is in order", 100, "\u00A0%");
  add("min_steps_per_contact", "steps in the shortest contact", "whether the step is in order");
  return section("Balances", table.html());
}

std::string speed(const Json& record) {
  Facts facts;
  const auto duration = [&](const char* key) {
    const double seconds = number_in(record, key);
    return std::isnan(seconds) ? "" : duration_text(seconds);
  };
  if (const double rate = number_in(record, "particle_steps_per_second"); rate > 0)
    facts.add("speed", fmt::format("{} million particle-steps per second", number_text(1e-6 * rate, 3)));
  facts.add("wall time", duration("wall_s"));
  facts.add("for steps", duration("stepping_s"));
  facts.add("for output", duration("output_s"));
  if (const double threads = number_in(record, "threads"); !std::isnan(threads))
    facts.add("threads", count_text(threads));
  const Json& size = object_in(record, "footprint");
  if (const double bytes = number_in(size, "bytes_per_body"); !std::isnan(bytes))
    facts.add("memory", fmt::format("{} bytes per body, {} per pair", count_text(bytes),
                                    count_text(number_in(size, "bytes_per_pair"))));
  if (const double searches = number_in(record, "neighbour_searches"); !std::isnan(searches))
    facts.add("neighbour searches", count_text(searches));
  return section("Speed", facts.html());
}

std::string run_charts(const Results& results) {
  Figures figures;
  Columns columns(tables_in(results.directory));
  try {
    if (!add_scene_charts(results, columns, figures)) add_energy_chart(columns, figures);
  } catch (const Error& error) {  // a table that is too large
    figures.add_line(escaped(error.what()));
  }
  return section("Charts", figures.html());
}

}  // namespace

std::string run_sections(const Results& results) {
  return verdict(results) + scene_pictures(results) + scene_facts(results) + stages(results.record) +
         expectations(results) + warnings(results) + run_charts(results) + cycles_section(results) +
         balances(results.record) + speed(results.record) + repetition(results);
}

}  // namespace scree::report
