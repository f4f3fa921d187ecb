#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <scree/error.hpp>

namespace CLI {
class App;
class Option;
}  // namespace CLI

// The command line as the verbs see it: command_line.cpp alone includes CLI11, whose templates take longer to
// compile than a verb.
namespace scree::tool {

// What an option sets; its type decides which words are taken.
using Destination =
    std::variant<std::reference_wrapper<std::string>, std::reference_wrapper<std::vector<std::string>>,
                 std::reference_wrapper<int>, std::reference_wrapper<unsigned>,
                 std::reference_wrapper<std::uint64_t>, std::reference_wrapper<double>,
                 std::reference_wrapper<std::optional<double>>>;

// One option of a verb, and what else is known of it.
class Option {
 public:
  Option& required();
  Option& shown_as(const std::string& type);  // in the help, such as DIR
  Option& one_of(const std::vector<std::string>& words);
  Option& existing_path();
  Option& finite();                            // a number, neither infinite nor NaN
  Option& above_zero();                        // a finite number
  Option& between(double least, double most);  // a number; both ends are taken
  Option& excludes(const Option& other);

 private:
  friend class Verb;
  Option(CLI::Option* option, Destination value) : option_(option), value_(value) {}

  CLI::Option* option_;
  Destination value_;
};

// What `scree <name>` takes and does.
class Verb {
 public:
  // "--name", or "name" for a word by its place. --name of several values is repeated for each.
  Option option(const std::string& name, Destination value, const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);
  // A flag of an earlier version, which the help does not show: refused with this line.
  void moved(const std::string& name, const std::string& line);
  // The text that ends the help; a function is called for it only when the help is shown.
  void footer(const std::string& text);
  void footer(const std::function<std::string()>& text);
  // Called once all options are set.
  void action(const std::function<ExitStatus()>& action);

 private:
  friend class CommandLine;
  Verb(CLI::App* verb, ExitStatus& status) : verb_(verb), status_(status) {}

  CLI::App* verb_;
  ExitStatus& status_;
};

// The whole program's.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& version, const std::string& footer);
  ~CommandLine();
  Verb verb(const std::string& name, const std::string& help);
  // For a verb of an earlier version: `scree NAME` is answered with "scree NAME <line>".
  void moved(const std::string& name, const std::string& line);
  // Does what the arguments ask for: a verb's action, help, or the version. Throws Error for wrong usage.
  ExitStatus run(int argc, char** argv);

 private:
  void check_verb_name(const std::string& name) const;
  void check_option_names(int argc, char** argv) const;

  std::unique_ptr<CLI::App> app_;
  std::map<std::string, std::string> moved_;
  ExitStatus status_ = ExitStatus::success;
};

}  // namespace scree::tool
