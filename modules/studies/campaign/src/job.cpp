#include "job.hpp"

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

}  // namespace

std::vector<std::string> command_of(const Job& job, const std::filesystem::path& directory,
                                    const ExecutionOptions& options) {
  std::vector<std::string> words = {options.program.string()};
  const std::filesystem::path plain = directory.string().starts_with('-') ? "." / directory : directory;
  const std::vector<std::string> verb =
      job.goes_on ? std::vector<std::string>{"resume", plain.string()} : run_words(job, directory.string());
  words.insert(words.end(), verb.begin(), verb.end());
  words.insert(words.end(), {"--threads", std::to_string(options.threads)});
  for (const std::string& plugins : options.plugin_directories)
    words.insert(words.end(), {"--plugins", plugins});
  return words;
}

}  // namespace scree::campaign
