#include "slurm.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/child_process.hpp>
#include <scree/error.hpp>
#include <scree/files/descriptor.hpp>
#include <scree/files/text.hpp>

namespace scree::campaign {

namespace {

struct Answer {
  int status = -1;
  std::vector<std::string> lines;  // of standard output and error
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

Answer call(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw Error(words.front(), fmt::format("cannot be called ({})", std::strerror(errno)), "try again");
  const files::Descriptor input(ends[0]);
  files::Descriptor output(ends[1]);
  const StartedProgram started = start_program(words, {.output = output.get(), .own_group = true});
  output = files::Descriptor();
  if (started.process < 0)
    throw Error(words.front(),
                fmt::format("is not there ({})",
                            std::strerror(started.not_executed ? started.not_executed : started.no_process)),
                "call scree where the commands of Slurm are, or leave --on slurm out");
  std::string text;
  char block[4096];
  for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);)
    if (count = read(input.get(), block, sizeof(block)); count > 0) text.append(block, std::size_t(count));
  const int status = wait_for(started.process);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, lines_of(text)};
}

// The last line of a command that failed, without "sbatch: error: " and "Batch job submission failed: ".
std::string reason_of(const Answer& answer, const std::string& command) {
  std::string line =
      answer.lines.empty() ? fmt::format("ended with status {}", answer.status) : answer.lines.back();
  const std::string prefixes[] = {command + ": ", "error: ", "Batch job submission failed: "};
  for (const std::string& prefix : prefixes)
    if (line.starts_with(prefix)) line.erase(0, prefix.size());
  return files::one_line(line, 200);
}

Answer answered(const std::vector<std::string>& words) {
  Answer answer = call(words);
  if (answer.status == 0) return answer;
  throw Error(words.front(), reason_of(answer, words.front()),
              "see that Slurm answers (sinfo), and repeat the command");
}

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<std::string> split(const std::string& line, char at, std::size_t most) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; parts.size() + 1 < most && (end = line.find(at, begin)) != line.npos; begin = end + 1)
    parts.push_back(line.substr(begin, end - begin));
  parts.push_back(line.substr(begin));
  return parts;
}

const char* cure_of(const std::string& reason) {
  if (reason.find("artition") != std::string::npos) return "give one of sinfo --format=%P with --partition";
  for (const char* of_limit : {"limit", "QOS", "Limit"})
    if (reason.find(of_limit) != std::string::npos)
      return "repeat the command when some of your jobs have ended, or ask for less";
  return "change --partition, --time or [slurm], and repeat the command";
}

}  // namespace

namespace slurm {

std::size_t largest_array() {
  constexpr std::size_t of_slurm = 1001;  // where it is not configured
  for (const std::string& line : answered({"scontrol", "show", "config"}).lines)
    if (line.starts_with("MaxArraySize"))
      if (const auto size = number_in(line.substr(line.find_last_of("= ") + 1)))
        return std::max<std::size_t>(1, *size);
  return of_slurm;
}

std::vector<QueuedJob> queue(const std::string& name) {
  constexpr std::size_t fields = 5;
  std::vector<QueuedJob> jobs;
  const std::vector<std::string> words = {"squeue", "--noheader", "--array", "--name=" + name,
                                          "--format=%F|%K|%T|%r|%k"};
  for (const std::string& line : answered(words).lines) {
    const std::vector<std::string> parts = split(line, '|', fields);
    if (parts.size() == fields && number_in(parts[0]))
      jobs.push_back({parts[0], number_in(parts[1]), parts[2], parts[3], parts[4]});
  }
  return jobs;
}

std::string submit(const std::vector<std::string>& words) {
  std::vector<std::string> all = {"sbatch", "--parsable"};
  all.insert(all.end(), words.begin(), words.end());
  const Answer answer = call(all);
  for (const std::string& line : answer.lines)  // among warnings of the site
    if (const std::string number = line.substr(0, line.find(';')); answer.status == 0 && number_in(number))
      return number;
  const std::string reason = reason_of(answer, "sbatch");
  throw Error("sbatch", reason, cure_of(reason));
}

std::vector<std::string> states(const std::string& job) {
  std::vector<std::string> states;
  for (const std::string& line : call({"scontrol", "--oneliner", "show", "job", job}).lines) {
    constexpr std::string_view key = " JobState=";
    const std::size_t at = line.find(key);
    if (at != line.npos)
      states.push_back(line.substr(at + key.size(), line.find(' ', at + key.size()) - at - key.size()));
  }
  return states;
}

}  // namespace slurm

std::vector<Array> arrays_of(const std::vector<std::size_t>& tasks, std::size_t largest) {
  std::vector<Array> arrays;
  for (const std::size_t task : tasks) {
    if (arrays.empty() || task - arrays.back().first >= largest) arrays.push_back({task, {}});
    arrays.back().elements.push_back(task - arrays.back().first);
  }
  return arrays;
}

std::string ranges_of(const std::vector<std::size_t>& elements) {
  std::vector<std::string> ranges;
  for (std::size_t k = 0; k < elements.size();) {
    std::size_t end = k + 1;
    while (end < elements.size() && elements[end] == elements[end - 1] + 1) ++end;
    ranges.push_back(end - k > 1 ? fmt::format("{}-{}", elements[k], elements[end - 1])
                                 : std::to_string(elements[k]));
    k = end;
  }
  return fmt::format("{}", fmt::join(ranges, ","));
}

std::vector<std::size_t> elements_of(const std::string& ranges) {
  std::vector<std::size_t> elements;
  for (const std::string& range : split(ranges, ',', std::string::npos)) {
    const std::vector<std::string> ends = split(range, '-', 2);
    const auto first = number_in(ends.front()), last = number_in(ends.back());
    if (first && last)
      for (std::size_t k = *first; k <= *last; ++k) elements.push_back(k);
  }
  return elements;
}

}  // namespace scree::campaign
