#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include <scree/nearest.hpp>

#include "verbs.hpp"

namespace scree::tool {

void add_plugin_options(CLI::App& verb, PluginOptions& options) {
  verb.add_option("--plugins", options.directories,
                  "Directory with plug-ins of your own, <DIR>/<kind>/<name>.so; also SCREE_PLUGIN_PATH=DIR:DIR")
      ->type_name("DIR")
      ->allow_extra_args(false);
}

PluginHost make_host(const PluginOptions& options) {
  std::vector<std::filesystem::path> directories(options.directories.begin(), options.directories.end());
  for (const auto& directory : directories)
    if (!std::filesystem::is_directory(directory))
      throw Error(fmt::format("--plugins {}: is no directory; name the one that holds contact/, boundary/, body/, probe/", directory.string()));
  if (const char* path = std::getenv("SCREE_PLUGIN_PATH")) {
    std::istringstream parts(path);
    for (std::string part; std::getline(parts, part, ':');)
      if (!part.empty()) directories.emplace_back(part);
  }
  for (const auto& directory : PluginHost::default_directories()) directories.push_back(directory);
  return PluginHost(std::move(directories));
}

namespace {

constexpr const char* footer =
    "Example:\n"
    "  scree run scenarios/david2005/quickstart.toml --out runs/first\n"
    "  scree describe linear_spring_dashpot normal_stiffness=5000 normal_damping=0.05\n"
    "Exit status: 0 done, 1 an expectation was not met, 2 bad input (nothing written), 3 the run blew up\n"
    "(what it wrote is kept), 130 interrupted (the same).";

int report(const std::string& line, ExitStatus status) {
  fmt::print(stderr, "scree: {}\n", line);
  return int(status);
}

// A verb that does not exist deserves a better answer than "unexpected argument".
void check_verb_name(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), argv[1]) != verbs.end()) return;
  const auto near = nearest_word(argv[1], verbs);
  throw Error(near ? fmt::format("no verb '{}'; did you mean '{}'?", argv[1], *near)
                   : fmt::format("no verb '{}'; see scree --help", argv[1]));
}

int main_of(int argc, char** argv) {
  CLI::App app("scree: a discrete-element laboratory for granular matter", "scree");
  app.footer(footer);
  app.set_version_flag("--version", "scree " SCREE_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  ExitStatus status = ExitStatus::success;
  add_run_verb(app, status);
  add_check_verb(app, status);
  add_describe_verb(app, status);
  add_render_verb(app, status);
  try {
    check_verb_name(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    return report(fmt::format("{}; see scree {}--help", error.what(), argc > 1 && argv[1][0] != '-' ? std::string(argv[1]) + " " : ""), ExitStatus::bad_input);
  } catch (const Error& error) {
    return report(error.what(), error.status());
  } catch (const std::exception& error) {
    return report(error.what(), ExitStatus::failure);
  }
  return int(status);
}

}  // namespace

}  // namespace scree::tool

int main(int argc, char** argv) { return scree::tool::main_of(argc, argv); }
