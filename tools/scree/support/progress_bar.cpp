#include "support/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

constexpr double seconds_between_plain_lines = 5;
constexpr int bar_width = 30;

}  // namespace

std::string duration_text(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  if (s >= 60) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} s", s);
}

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO)) {}

void ProgressBar::show(const run::Progress& p) {
  std::string what = fmt::format("t = {:.4g} s  {}", p.time, files::escaped(p.stage));
  if (p.stages > 1) what += fmt::format(" (stage {} of {})", p.stage_number, p.stages);
  if (p.share) return show(*p.share, p.wall_time, what);
  if (!p.conditions.empty()) what += ", " + files::escaped(p.conditions);
  print("", fmt::format("{}, {} so far", what, duration_text(p.wall_time)), p.wall_time);
}

void ProgressBar::show(double share, double wall_time, std::string_view what) {
  if (share < first_share_) first_share_ = share, first_wall_ = wall_time;
  const int full = int(std::clamp(share, 0.0, 1.0) * bar_width);
  print(fmt::format("[{}{}] ", std::string(std::size_t(full), '#'),
                    std::string(std::size_t(bar_width - full), '.')),
        fmt::format("{:3.0f} %  {}{}", 100 * share, what, time_left(share, wall_time)), wall_time);
}

std::string ProgressBar::time_left(double share, double wall_time) const {
  const double done = share - first_share_, taken = wall_time - first_wall_;
  if (done <= 0 || taken < 0.5) return "";
  return fmt::format(", {} left", duration_text(taken * (1 - share) / done));
}

void ProgressBar::print(const std::string& bar, const std::string& text, double wall_time) {
  if (quiet_) return;
  if (terminal_) {
    fmt::print(stderr, "\r{}{}\x1b[K", bar, text);
    std::fflush(stderr);
  } else if (wall_time >= next_plain_line_) {
    if (wall_time >= 1) fmt::print("{}\n", text), std::fflush(stdout);
    next_plain_line_ = wall_time + (next_plain_line_ > 0 ? seconds_between_plain_lines : 2);
  }
}

void ProgressBar::clear() {
  if (terminal_ && !quiet_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace scree::tool
