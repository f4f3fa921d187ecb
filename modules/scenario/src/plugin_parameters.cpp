#include "plugin_parameters.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/plugin/program.hpp>

namespace scree::scenario {

namespace {

// Each of these keys makes a table a function of its own.
void refuse_mixture(const document::Table& t) {
  std::vector<std::string> given;
  for (const char* key : {"table", "amplitude", "period", "duration"})
    if (t.has(key)) given.push_back(key);
  if (given.size() > 1)
    throw t.error(given[1],
                  fmt::format("'{}' and '{}' belong to different functions of time", given[0], given[1]),
                  "keep one: period (there and back, again and again), duration (once from 'from' to 'to'), "
                  "amplitude (a sine), or table");
}

// A function of time: a number, or a table whose keys determine its kind (see program.hpp of the framework).
std::vector<double> read_program(const document::Table& table, const scree_parameter& p) {
  if (!table.is_table(p.key)) return {Program::constant, table.number(p.key)};
  const document::Table t = table.table(p.key);
  refuse_mixture(t);
  if (t.optional("table")) {
    std::vector<double> data = {Program::table};
    double last = -std::numeric_limits<double>::infinity();
    for (const auto& row : t.rows("table", 2)) {
      if (row[0] <= last)
        throw t.error("table", "the times do not increase", "sort the rows, with every time only once");
      last = row[0];
      data.insert(data.end(), row.begin(), row.end());
    }
    if (data.size() == 1) throw t.error("table", "'table' has no rows", "give [[time, value], ...]");
    return data;
  }
  if (t.optional("amplitude"))
    return {Program::sine, t.number("mean", 0.0), t.number("amplitude"),
            t.number("frequency_hz", document::Range::positive("Hz")),
            t.number("phase_deg", 0.0) * std::numbers::pi / 180};
  if (t.optional("period"))
    return {Program::cycle, t.number("from"), t.number("to"),
            t.number("period", document::Range::positive("s"))};
  if (t.optional("duration"))
    return {Program::ramp, t.number("from"), t.number("to"),
            t.number("duration", document::Range::positive("s"))};
  throw t.error(fmt::format("'{}' is not a function of time", p.key),
                "give a number, {from, to, period}, {from, to, duration}, {mean, amplitude, frequency_hz} or "
                "{table = [[t, value], ...]}");
}

std::vector<double> read_value(const document::Table& table, const scree_parameter& p, int dimension) {
  switch (scree_type(p.type)) {
    case SCREE_INTEGER:
      return {double(table.integer(p.key))};
    case SCREE_BOOLEAN:
      return {table.boolean(p.key) ? 1.0 : 0.0};
    case SCREE_CHOICE: {
      const std::vector<std::string> words = choices_of(p);
      const std::string word = table.choice(p.key, words);
      return {double(std::find(words.begin(), words.end(), word) - words.begin())};
    }
    case SCREE_VECTOR: {
      std::vector<double> v = table.numbers(p.key, std::size_t(dimension));
      v.resize(3, 0.0);
      return v;
    }
    case SCREE_LIST:
      return table.numbers(p.key);
    case SCREE_PROGRAM:
      return read_program(table, p);
    case SCREE_NUMBER:
      break;
  }
  return {table.number(p.key)};
}

// text: "problem; cure" from the framework.
[[noreturn]] void refuse(const document::Table& table, const std::string& key, const std::string& text) {
  const auto semicolon = text.find("; ");
  throw table.error(key, fmt::format("{} {}", key, text.substr(0, semicolon)),
                    semicolon == std::string::npos ? "see scree describe" : text.substr(semicolon + 2));
}

}  // namespace

const scree_plugin& find_plugin(const document::Table& table, scree_kind kind, PluginHost& host) {
  const std::string name = table.string("plugin");
  if (name.size() >= SCREE_MAX_NAME)
    throw table.error("plugin", fmt::format("the name of the plug-in has {} or more letters", SCREE_MAX_NAME),
                      "see scree describe for the names");
  if (const std::string shown = files::escaped(name); shown != name)
    throw table.error("plugin", fmt::format("the name '{}' has control characters", shown),
                      "see scree describe for the names");
  return placed(table, "plugin", [&]() -> const scree_plugin& { return host.find(name, kind); });
}

void read_parameters(const document::Table& table, int dimension, Parameters& parameters) {
  const scree_plugin& plugin = parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    if (!table.optional(p.key)) continue;
    std::vector<double> data = read_value(table, p, dimension);
    if (const auto wrong = Parameters::problem(p, data)) refuse(table, p.key, *wrong);
    parameters.set(p.key, std::move(data));
  }
}

void check_complete(const document::Table& table, const Parameters& parameters) {
  placed(table, "plugin", [&] { parameters.check_complete(); });
}

}  // namespace scree::scenario
