#include "common_sections.hpp"

#include "html.hpp"
#include "numbers.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/document/document.hpp>
#include <scree/report/record.hpp>

namespace scree::report {

std::string title_of(const Results& results) {
  if (std::string title = text_in(results.record, "title"); !title.empty()) return title;
  try {
    const auto scenario = document::Document::parse(text_in(results.record, "scenario"), "scenario");
    const auto scene = scenario.root().optional_table("scene");
    if (const auto title = scene ? scene->optional_string("title") : std::nullopt) return *title;
  } catch (const Error&) {
    // A record that was edited.
  }
  std::error_code failed;
  return std::filesystem::absolute(results.directory / "", failed).parent_path().filename().string();
}

std::string mark(const char* kind, const std::string& text) {
  return fmt::format("<p class=\"verdict {}\">{}</p>\n", kind, escaped(text));
}

namespace {

std::string status_line(const Results& results) {
  const std::string status = text_in(results.record, "status"), noun = results.noun;
  if (status == "finished") return mark("good", fmt::format("The {} finished.", noun));
  if (status == "failed")
    return mark("bad", fmt::format("The {} failed: {}", noun, text_in(results.record, "error")));
  if (status == "interrupted")
    return mark("open", fmt::format("The {} was interrupted before its end.", noun));
  return mark("open", fmt::format("The {} had not ended when this page was written.", noun));
}

std::string expectation_line(const Json& all) {
  std::size_t met = 0;
  for (const Json& one : all) met += is_true_in(one, "met");
  if (all.empty()) return "";
  if (met == all.size())
    return mark("good", all.size() == 1 ? "Its expectation is met."
                                        : fmt::format("All {} expectations are met.", all.size()));
  const std::size_t unmet = all.size() - met;
  return mark("bad", fmt::format("{} of {} {} not met.", unmet, counted(all.size(), "expectation"),
                                 unmet == 1 ? "is" : "are"));
}

// "0.5 ± 0.01", "at most 2".
std::string requirement_text(const Json& expectation) {
  std::vector<std::string> parts;
  const double reference = number_in(expectation, "reference"),
               tolerance = number_in(expectation, "tolerance");
  if (!std::isnan(reference))
    parts.push_back(fmt::format("{} ± {}", number_text(reference, 6), number_text(tolerance, 2)));
  for (const auto& [key, words] : {std::pair("at_least", "at least"), {"at_most", "at most"}})
    if (const double limit = number_in(expectation, key); !std::isnan(limit))
      parts.push_back(fmt::format("{} {}", words, number_text(limit, 6)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string verdict(const Results& results) {
  return status_line(results) + expectation_line(list_in(results.record, "expect"));
}

std::string expectations(const Results& results) {
  Table table({{""}, {"requirement"}, {"quantity"}, {"value", true}, {"expected", true}});
  for (const Json& one : list_in(results.record, "expect"))
    table.add(
        {is_true_in(one, "met") ? "<span class=\"good\">met</span>" : "<span class=\"bad\">not met</span>",
         escaped(text_in(one, "requirement")), code(text_in(one, "quantity")),
         number_text(number_in(one, "value"), 6), escaped(requirement_text(one))});
  return section("Expectations", table.html("the record"));
}

std::string warnings(const Results& results) {
  constexpr std::size_t most = 50;
  const Json& all = list_in(results.record, "warnings");
  std::string items;
  std::size_t count = 0;
  for (const Json& one : all)
    if (one.is_string() && ++count <= most) items += element("li", escaped(one.get<std::string>())) + '\n';
  if (count > most) items += element("li", escaped(fmt::format("and {} more", count - most)));
  return section("Warnings", items.empty() ? "" : "<ul>\n" + items + "</ul>\n");
}

namespace {

// A word for the shell: in quotes unless all its characters stand for themselves there.
std::string shell_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_./,:=+-@%").find(char(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

// Of the command line, as the record has them: a flag is true, an option that is repeated a list.
std::string options_of(const Json& options) {
  std::string words;
  for (const auto& [key, value] : options.items()) {
    std::string name = " --" + key;
    std::replace(name.begin(), name.end(), '_', '-');
    const auto add = [&](const Json& one) {
      if (one.is_string()) words += name + ' ' + shell_word(one.get<std::string>());
      if (one.is_number()) words += name + ' ' + one.dump();
    };
    if (value.is_boolean() && value.get<bool>()) words += name;
    add(value);
    for (const Json& one : value.is_array() ? value : Json::array()) add(one);
  }
  return words;
}

std::string call_of(const Results& results) {
  if (const Json& options = object_in(results.record, "options"); !options.empty())
    return fmt::format("scree {} scenario.toml --out again{}", results.verb, options_of(options));
  // Records of versions that did not write them.
  std::string options;
  if (results.verb == std::string_view("spectrum")) {
    const Json& methods = list_in(results.record, "methods");
    const std::string first = methods.empty() ? "sweep" : text_in(methods.front(), "method");
    options = " --by " + (methods.size() == 1 || first.starts_with("sweep") ? first : "all");
  }
  if (const double tolerance = number_in(results.record, "tolerance"); !std::isnan(tolerance))
    options = fmt::format(" --tolerance {}", tolerance);
  return fmt::format("scree {} scenario.toml --out again{}", results.verb, options);
}

}  // namespace

std::string program_of(const Results& results) {
  const std::string commit = text_in(results.record, "commit");
  return escaped("scree " + text_in(results.record, "version")) +
         (commit.empty() ? "" : ", commit " + code(commit));
}

std::string repetition(const Results& results) {
  const bool knows_all =
      results.verb == std::string_view("run") || !object_in(results.record, "options").empty();
  const char* const of_first_call = knows_all ? "" : ", with the other options of the first call";
  Facts facts;
  facts.add("command", code(call_of(results)) + " in this directory" + of_first_call);
  facts.add("program", program_of(results));
  if (const double seed = number_in(results.record, "seed"); !std::isnan(seed))
    facts.add("seed", fmt::format("{:.0f}", seed));
  if (const std::string hash = text_in(results.record, "state_hash"); !hash.empty())
    facts.add("state hash at the end", code(hash) + ", the same for any number of threads");
  const Json& inputs = object_in(results.record, "inputs");
  if (const std::string bodies = text_in(inputs, "bodies"); !bodies.empty())
    facts.add("hash of the files of bodies", code(bodies));
  std::string plugins;
  for (const auto& [name, hash] : object_in(inputs, "plugins").items())
    if (hash.is_string())
      plugins += fmt::format("<li>{} {}</li>\n", escaped(name), code(hash.get<std::string>()));
  if (!plugins.empty()) facts.add("hashes of the plug-ins", "<ul class=\"plain\">\n" + plugins + "</ul>\n");
  return section("How to repeat it", facts.html() + scenario_text(results));
}

std::string scenario_text(const Results& results) {
  constexpr std::size_t longest = 1u << 16;  // (bytes) of what is printed
  const std::string text = text_in(results.record, "scenario");
  if (text.empty()) return "";
  return folded("The scenario as it was resolved",
                "<pre><code>" + escaped_lines(text, longest) + "</code></pre>\n");
}

}  // namespace scree::report
