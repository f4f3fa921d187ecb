#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include <scree/error.hpp>
#include <scree/plugin_host.hpp>

namespace scree::tool {

// Writes "scree: <line>" to stderr, in one line whatever the text holds, and returns the status.
ExitStatus report(std::string_view line, ExitStatus status);

// What every verb that looks at plug-ins shares.
struct PluginOptions {
  std::vector<std::string> directories;
};

// Adds --plugins DIR.
void add_plugin_options(CLI::App& verb, PluginOptions& options);
// Directories of --plugins, then of SCREE_PLUGIN_PATH, then of the build or install tree.
PluginHost make_host(const PluginOptions& options);

// A check for options; CLI::PositiveNumber takes infinity.
std::string positive_and_finite(const std::string& word);

// Each adds its verb; the callback sets `status`.
void add_run_verb(CLI::App& app, ExitStatus& status);
void add_check_verb(CLI::App& app, ExitStatus& status);
void add_describe_verb(CLI::App& app, ExitStatus& status);
void add_render_verb(CLI::App& app, ExitStatus& status);
void add_accuracy_verb(CLI::App& app, ExitStatus& status);
void add_campaign_verb(CLI::App& app, ExitStatus& status);
void add_bench_verb(CLI::App& app, ExitStatus& status);

// Set by the first Ctrl-C, or the end of a batch job, from now on: what runs saves what it has and ends. A
// second one ends the program at once.
const std::atomic<bool>& watch_for_interrupt();

}  // namespace scree::tool
