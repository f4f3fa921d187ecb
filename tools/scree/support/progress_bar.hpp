#pragma once

#include <string>
#include <string_view>

#include <scree/run/run.hpp>

namespace scree::tool {

// One line that moves where stderr is a terminal; elsewhere a plain line every few seconds on stdout, so that
// stderr holds nothing but what went wrong.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  // Cleared also where an error leaves, so that its line stands alone.
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  // Without a share: what the end of the stage waits for, and its value so far.
  void show(const run::Progress& progress);
  // A share from 0 to 1, seconds since the start, and what is going on.
  void show(double share, double wall_time, std::string_view what);
  // Clears the moving line, so that other text can follow.
  void clear();

 private:
  // From the progress since the first share shown: what is resumed begins above 0.
  std::string time_left(double share, double wall_time) const;
  void print(const std::string& bar, const std::string& text, double wall_time);

  bool quiet_, terminal_;
  double next_plain_line_ = 0;  // (s) of wall time
  double first_share_ = 2;      // above any share until one is shown
  double first_wall_ = 0;       // (s)
};

// "1 h 05 min", "2 min 10 s", "8 s".
std::string duration_text(double seconds);

}  // namespace scree::tool
