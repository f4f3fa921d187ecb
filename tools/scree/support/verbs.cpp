#include "support/verbs.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::tool {

namespace {

bool reports_are_printed = true;

}  // namespace

void print_reports(bool print) { reports_are_printed = print; }

ExitStatus report(std::string_view line, ExitStatus status) {
  constexpr std::size_t longest = 4000;
  if (reports_are_printed)
    std::fputs(fmt::format("scree: {}\n", files::one_line(line, longest)).c_str(), stderr);
  return status;
}

void report_warning(std::string_view line) { report(fmt::format("warning: {}", line), ExitStatus::success); }

std::filesystem::path program_folder() {
  std::error_code failed;
  return std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
}

std::filesystem::path data_folder(const std::filesystem::path& installed,
                                  const std::filesystem::path& in_source_tree) {
  std::error_code failed;
  const std::filesystem::path folder = (program_folder() / installed).lexically_normal();
  return std::filesystem::is_directory(folder, failed) ? folder : in_source_tree;
}

void add_plugin_options(Verb& verb, PluginOptions& options) {
  verb.option("--plugins", options.directories,
              "Directory with additional plug-ins, <DIR>/<kind>/<name>.so; also SCREE_PLUGIN_PATH=DIR:DIR")
      .shown_as("DIR");
}

namespace {

void check_plugin_directory(const char* source, const std::filesystem::path& directory) {
  if (std::error_code failed; !std::filesystem::is_directory(directory, failed))
    throw Error(fmt::format(
        "{}{}: is not a directory; give the one that contains contact/, boundary/, body_force/, probe/",
        source, directory.string()));
}

}  // namespace

void add_checkpoint_option(Verb& verb, std::string& text) {
  verb.option("--checkpoint-every", text,
              "Wall time between checkpoints, such as 30s, 10min, 2h or never; default that of the scenario")
      .shown_as("TIME");
}

std::optional<double> wall_time_option(const char* option, const std::string& text) {
  try {
    return scenario::parse_wall_time(text);
  } catch (const Error& error) {
    throw error.at(option, ExitStatus::bad_input);
  }
}

PluginHost make_host(const PluginOptions& options) {
  std::vector<std::filesystem::path> directories(options.directories.begin(), options.directories.end());
  for (const auto& directory : directories) check_plugin_directory("--plugins ", directory);
  if (const char* path = std::getenv("SCREE_PLUGIN_PATH")) {
    std::istringstream parts(path);
    for (std::string part; std::getline(parts, part, ':');) {
      if (part.empty()) continue;
      check_plugin_directory("SCREE_PLUGIN_PATH: ", part);
      directories.emplace_back(part);
    }
  }
  for (const auto& directory : PluginHost::default_directories()) directories.push_back(directory);
  return PluginHost(std::move(directories));
}

}  // namespace scree::tool
