#pragma once

#include "support/command_line.hpp"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin_host.hpp>

namespace scree::tool {

// Writes "scree: <line>" to stderr, in one line whatever the text holds, and returns the status.
ExitStatus report(std::string_view line, ExitStatus status);
// Whether report() prints: not in a task whose errors another one has as well.
void print_reports(bool print);
// Writes "scree: warning: <line>" to stderr.
void report_warning(std::string_view line);

// The folder of the running program.
std::filesystem::path program_folder();
// Where files that come with the program are: `installed`, relative to the program, or in the source tree.
std::filesystem::path data_folder(const std::filesystem::path& installed,
                                  const std::filesystem::path& in_source_tree);

// What every verb that looks at plug-ins shares.
struct PluginOptions {
  std::vector<std::string> directories;
};

// Adds --plugins DIR.
void add_plugin_options(Verb& verb, PluginOptions& options);
// Directories of --plugins, then of SCREE_PLUGIN_PATH, then of the build or install tree.
PluginHost make_host(const PluginOptions& options);

// Adds --checkpoint-every TIME.
void add_checkpoint_option(Verb& verb, std::string& text);
// The wall time (s) that an option gives; nothing for "never". Throws Error "<option>: ...".
std::optional<double> wall_time_option(const char* option, const std::string& text);

// Set from now on by the first Ctrl-C, end of a batch job (SIGTERM, SIGUSR1) or closed terminal (SIGHUP):
// what runs saves what it has and ends. Ctrl-C more than a second later ends the program at once. Signals
// that were ignored at the start stay so.
const std::atomic<bool>& watch_for_interrupt();

}  // namespace scree::tool
