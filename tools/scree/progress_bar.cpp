#include "progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace scree::tool {

namespace {

constexpr double seconds_between_plain_lines = 5;
constexpr int bar_width = 30;

std::string time_left(const scenario::Progress& p) {
  if (p.share <= 0 || p.wall < 0.5) return "";
  return fmt::format(", {} left", duration_text(p.wall * (1 - p.share) / p.share));
}

}  // namespace

std::string duration_text(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  if (s >= 60) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} s", s);
}

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO)) {}

void ProgressBar::show(const scenario::Progress& p) {
  if (quiet_) return;
  const std::string text =
      fmt::format("{:3.0f} %  t = {:.4g} s  {}{}", 100 * p.share, p.time, p.stage, time_left(p));
  if (terminal_) {
    const int full = int(std::clamp(p.share, 0.0, 1.0) * bar_width);
    fmt::print(stderr, "\r[{}{}] {}\x1b[K", std::string(std::size_t(full), '#'),
               std::string(std::size_t(bar_width - full), '.'), text);
    std::fflush(stderr);
  } else if (p.wall >= next_plain_line_) {
    if (p.wall >= 1) fmt::print("{}\n", text), std::fflush(stdout);
    next_plain_line_ = p.wall + (next_plain_line_ > 0 ? seconds_between_plain_lines : 2);
  }
}

void ProgressBar::clear() {
  if (terminal_ && !quiet_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace scree::tool
