#include "job.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::campaign {

namespace {

std::vector<std::string> run_words(const Job& job, const std::string& directory) {
  // A name that begins with "-" must not be taken for an option.
  const std::filesystem::path& scenario = job.campaign.scenario;
  const bool like_option = scenario.string().starts_with('-');
  std::vector<std::string> words = {job.campaign.methods.empty() ? "run" : "spectrum",
                                    (like_option ? "." / scenario : scenario).string(), "--out", directory,
                                    "--overwrite"};
  if (!job.campaign.methods.empty()) words.insert(words.end(), {"--by", job.campaign.methods});
  for (const std::string& text : job.point.overrides()) words.insert(words.end(), {"--set", text});
  return words;
}

// What starts the processes of a run. mpirun would bind each of two ranks to one core, whatever its threads,
// and ranks of several runs to the same ones.
std::vector<std::string> launcher(const ExecutionOptions& options) {
  if (options.ranks == 0) return {options.program.string()};
  // It is another program that follows the link.
  const std::string program = std::filesystem::canonical(options.program).string();
  const std::string count = std::to_string(options.ranks);
  if (std::getenv("SLURM_JOB_ID"))
    return {"srun",
            "--mpi=pmix",
            "--overlap",
            "--ntasks=" + count,
            "--cpus-per-task=" + std::to_string(options.threads),
            program};
  return {"mpirun", "--bind-to", "none", "-n", count, program};
}

constexpr std::size_t longest_problem = 1000;  // (bytes)

// Non-blank lines among the last 8192 bytes.
std::vector<std::string> last_lines(const std::filesystem::path& log) {
  constexpr std::streamoff max_bytes = 8192;
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  file.seekg(std::max<std::streamoff>(0, std::streamoff(file.tellg()) - max_bytes));
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<std::string> command_of(const Job& job, const std::filesystem::path& directory,
                                    const ExecutionOptions& options) {
  std::vector<std::string> words = launcher(options);
  const std::filesystem::path plain = directory.string().starts_with('-') ? "." / directory : directory;
  const std::vector<std::string> verb =
      job.goes_on ? std::vector<std::string>{"resume", plain.string()} : run_words(job, directory.string());
  words.insert(words.end(), verb.begin(), verb.end());
  words.insert(words.end(), {"--threads", std::to_string(options.threads)});
  if (options.ranks > 0) words.emplace_back("--ranks");
  for (const std::string& plugins : options.plugin_directories)
    words.insert(words.end(), {"--plugins", plugins});
  return words;
}

std::string reported_in(const std::filesystem::path& log) {
  constexpr std::string_view prefix = "scree: ", warning = "scree: warning: ";
  const std::vector<std::string> lines = last_lines(log);
  const auto reported = std::find_if(lines.rbegin(), lines.rend(), [&](const auto& line) {
    return line.starts_with(prefix) && !line.starts_with(warning);
  });
  return reported == lines.rend() ? "" : files::one_line(reported->substr(prefix.size()), longest_problem);
}

std::string problem_of(const std::filesystem::path& log, const std::string& how) {
  std::string problem = reported_in(log);
  if (problem.empty())
    if (const std::vector<std::string> lines = last_lines(log); !lines.empty()) problem = lines.back();
  if (!how.empty()) problem = problem.empty() ? how : fmt::format("{} ({})", problem, how);
  return problem.empty() ? "the run has no result" : files::one_line(problem, longest_problem);
}

std::string failed_with(const Point& preparation, const Outcome& outcome) {
  return fmt::format("{} failed: {}", preparation.name, outcome.problem);
}

double share_in(const std::filesystem::path& log) {
  const std::vector<std::string> lines = last_lines(log);
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    char* end = nullptr;
    const double percent = std::strtod(line->c_str(), &end);
    if (end != line->c_str() && std::string_view(end).starts_with(" %"))
      return std::clamp(percent / 100, 0.0, 1.0);
  }
  return 0;
}

}  // namespace scree::campaign
