#include "verbs.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <new>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::tool {

ExitStatus report(std::string_view line, ExitStatus status) {
  constexpr std::size_t longest = 4000;
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
    throw Error(fmt::format("{}: {}", option, error.what()));
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

namespace {

constexpr const char* footer =
    "Example:\n"
    "  scree run scenarios/david2005/quickstart.toml --out runs/first\n"
    "  scree describe linear_spring_dashpot normal_stiffness=5000 normal_damping=0.05\n"
    "Exit status: 0 done, 1 an expectation was not met, 2 bad input (nothing written), 3 the run blew up\n"
    "(what it wrote is kept), 130 interrupted (the same).";

// The next file opened would otherwise get the number of a closed descriptor, and with it what is printed.
void open_closed_descriptors() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
    if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) return;
}

constexpr const char* lost_output =
    "standard output cannot be written; free disk space or redirect it elsewhere";

// Output that did not reach its file must not pass for success.
ExitStatus flushed(ExitStatus status) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  throw Error(lost_output, ExitStatus::failure);
}

ExitStatus main_of(int argc, char** argv) {
  try {
    CommandLine line("scree: a discrete-element laboratory for granular matter", "scree " SCREE_VERSION,
                     footer);
    add_run_verb(line);
    add_resume_verb(line);
    add_check_verb(line);
    add_describe_verb(line);
    add_render_verb(line);
    add_accuracy_verb(line);
    add_campaign_verb(line);
    add_bench_verb(line);
    add_spectrum_verb(line);
    add_cycles_verb(line);
    add_response_verb(line);
    add_new_plugin_verb(line);
    add_test_plugin_verb(line);
    return flushed(line.run(argc, argv));
  } catch (const Error& error) {
    return report(error.what(), error.status());
  } catch (const std::bad_alloc&) {
    return report("out of memory; use fewer bodies, fewer samples or a computer with more",
                  ExitStatus::failure);
  } catch (const std::exception& error) {
    if (std::ferror(stdout)) return report(lost_output, ExitStatus::failure);
    return report(
        fmt::format("internal error: {}; please report it together with the scenario", error.what()),
        ExitStatus::failure);
  }
}

}  // namespace

}  // namespace scree::tool

int main(int argc, char** argv) {
  scree::tool::open_closed_descriptors();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is reported where a file is written
  static bool returned = false;
  // The program itself never calls exit; a plug-in may, with a status that would pass for a result.
  std::atexit([] {
    if (returned) return;
    std::fputs("scree: a plug-in ended the program with exit(); let it report the problem instead\n", stderr);
    std::_Exit(int(scree::ExitStatus::failure));
  });
  const int status = int(scree::tool::main_of(argc, argv));
  returned = true;
  return status;
}
