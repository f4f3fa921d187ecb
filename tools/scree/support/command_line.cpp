#include "support/command_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

bool is_finite(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return !word.empty() && !*end && std::isfinite(value);
}

std::string finite_number(const std::string& word) {
  double value = 0;
  return is_finite(word, value) ? "" : word + " is not a finite number";
}

// CLI::PositiveNumber takes infinity.
std::string positive_and_finite(const std::string& word) {
  double value = 0;
  return is_finite(word, value) && value > 0 ? "" : word + " is not a number above 0";
}

// CLI::Range takes NaN, and says of a word such as 1e9 that it is not in the range where it is no whole
// number.
template <class Number>
CLI::Validator range(Number least, Number most) {
  const auto check = [least, most](const std::string& word) {
    Number value{};
    if (CLI::detail::lexical_cast(word, value) && value >= least && value <= most) return std::string();
    return fmt::format("{} is not a {} from {} to {}, in digits", word,
                       std::is_integral_v<Number> ? "whole number" : "number", least, most);
  };
  return {check, fmt::format("{} in [{} - {}]", CLI::detail::type_name<Number>(), least, most)};
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::shown_as(const std::string& type) {
  option_->type_name(type);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

Option& Option::existing_path() {
  option_->check(CLI::ExistingPath);
  return *this;
}

Option& Option::finite() {
  option_->check(finite_number);
  return *this;
}

Option& Option::above_zero() {
  option_->check(positive_and_finite);
  return *this;
}

Option& Option::between(double least, double most) {
  const auto check = [&](auto value) {
    using Number = typename decltype(value)::type;  // the help names it
    if constexpr (std::is_arithmetic_v<Number>) option_->check(range(Number(least), Number(most)));
  };
  std::visit(check, value_);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option Verb::option(const std::string& name, Destination value, const std::string& help) {
  CLI::Option* option =
      std::visit([&](auto destination) { return verb_->add_option(name, destination.get(), help); }, value);
  // Else --set a=1 scene.toml would take the scene for a second value.
  if (name.starts_with('-')) option->allow_extra_args(false);
  return Option(option, value);
}

void Verb::flag(const std::string& name, bool& value, const std::string& help) {
  verb_->add_flag(name, value, help);
}

void Verb::moved(const std::string& name, const std::string& line) {
  verb_->add_flag_callback(name, [line] { throw Error(line); })->group("");
}

void Verb::footer(const std::string& text) { verb_->footer(text); }

void Verb::footer(const std::function<std::string()>& text) { verb_->footer(text); }

void Verb::action(const std::function<ExitStatus()>& action) {
  verb_->callback([action, &status = status_] { status = action(); });
}

CommandLine::CommandLine(const std::string& description, const std::string& version,
                         const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, "scree")) {
  app_->footer(footer);
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
  app_->get_formatter()->column_width(34);
}

CommandLine::~CommandLine() = default;

Verb CommandLine::verb(const std::string& name, const std::string& help) {
  return Verb(app_->add_subcommand(name, help), status_);
}

void CommandLine::moved(const std::string& name, const std::string& line) { moved_[name] = line; }

// For a verb that does not exist the nearest one is named, in place of "unexpected argument".
void CommandLine::check_verb_name(const std::string& name) const {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app_->get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), name) != verbs.end()) return;
  if (const auto moved = moved_.find(name); moved != moved_.end())
    throw Error(fmt::format("scree {} {}", name, moved->second));
  throw Error(fmt::format("unknown command '{}'; {}", name, document::name_cure(name, verbs)));
}

// Likewise for an option.
void CommandLine::check_option_names(int argc, char** argv) const {
  std::vector<std::string> names, shown;
  for (const CLI::Option* option : app_->get_subcommand(argv[1])->get_options())
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
      if (!option->get_group().empty()) shown.push_back(names.back());
    }
  for (int k = 2; k < argc; ++k) {
    const std::string word = argv[k], name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::find(names.begin(), names.end(), name) != names.end()) continue;
    if (const std::string cure = document::suggestion(name, shown); !cure.empty())
      throw Error(
          fmt::format("unknown option '{}'; {}see scree {} --help", files::one_line(name), cure, argv[1]));
  }
}

ExitStatus CommandLine::run(int argc, char** argv) {
  const bool verb_given = argc > 1 && argv[1][0] != '-';
  if (verb_given) check_verb_name(argv[1]);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& done) {
    app_->exit(done);
  } catch (const CLI::ParseError& error) {
    if (verb_given) check_option_names(argc, argv);
    throw Error(
        fmt::format("{}; see scree {}--help", error.what(), verb_given ? std::string(argv[1]) + " " : ""));
  }
  return status_;
}

}  // namespace scree::tool
