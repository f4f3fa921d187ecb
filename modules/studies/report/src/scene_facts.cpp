#include "scene_facts.hpp"

#include "html.hpp"
#include "numbers.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/report/record.hpp>

namespace scree::report {

namespace {

// The values of a key in all tables of a name, each once, in their order.
std::string named(const document::Table& root, const char* table, const char* key) {
  std::vector<std::string> names;
  for (const document::Table& one : root.tables(table))
    if (one.is_string(key))
      if (const std::string name = one.string(key);
          std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  std::string html;
  for (const std::string& name : names) html += (html.empty() ? "" : ", ") + escaped(name);
  return html;
}

void add_plugins(const std::string& scenario, Facts& facts) {
  try {
    const document::Table root = document::Document::parse(scenario, "scenario").root();
    facts.add("materials", named(root, "material", "name"));
    facts.add("contact laws", named(root, "contact", "plugin"));
    facts.add("walls", named(root, "boundary", "plugin"));
    facts.add("body forces", named(root, "body_force", "plugin"));
    facts.add("probes", named(root, "probe", "plugin"));
  } catch (const Error&) {
    // A record that was edited.
  }
}

}  // namespace

std::string scene_facts(const Results& results) {
  const Json& record = results.record;
  const Json& size = object_in(record, "footprint");
  Facts facts;
  double bodies = number_in(size, "bodies"), freedom = number_in(size, "degrees_of_freedom");
  if (std::isnan(bodies)) bodies = number_in(record, "bodies");
  if (std::isnan(freedom)) freedom = number_in(record, "degrees_of_freedom");
  if (!std::isnan(bodies))
    facts.add("bodies",
              count_text(bodies) +
                  (std::isnan(freedom) ? "" : fmt::format(", {} degrees of freedom", count_text(freedom))));
  if (const double time = number_in(record, "time"); !std::isnan(time))
    facts.add("simulated time", with_unit(time, "s", 5));
  if (const double steps = number_in(record, "steps"); !std::isnan(steps))
    facts.add("steps", fmt::format("{} of {}", count_text(steps), with_unit(number_in(record, "step"), "s")));
  add_plugins(text_in(record, "scenario"), facts);
  return section("Scene", facts.html());
}

}  // namespace scree::report
