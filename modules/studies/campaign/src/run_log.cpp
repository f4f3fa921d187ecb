#include "run_log.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::campaign {

namespace {

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

std::string problem_of(const std::filesystem::path& log, const std::string& how) {
  constexpr std::string_view prefix = "scree: ", warning = "scree: warning: ";
  constexpr std::size_t max_length = 1000;
  const std::vector<std::string> lines = last_lines(log);
  const auto reported = std::find_if(lines.rbegin(), lines.rend(), [&](const auto& line) {
    return line.starts_with(prefix) && !line.starts_with(warning);
  });
  std::string problem = reported != lines.rend() ? reported->substr(prefix.size())
                        : lines.empty()          ? ""
                                                 : lines.back();
  if (!how.empty()) problem = problem.empty() ? how : fmt::format("{} ({})", problem, how);
  return problem.empty() ? "the run has no result" : files::one_line(problem, max_length);
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
