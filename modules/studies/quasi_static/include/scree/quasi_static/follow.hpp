#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::quasi_static {

struct FollowOptions {
  static constexpr unsigned increments_per_cycle = 40, fewest_per_cycle = 8;

  std::filesystem::path out;  // empty: runs/<stem of the scenario>-quasi-static, numbered if it exists
  bool overwrite = false;
  unsigned threads = 1;  // of the stages before
  unsigned increments =
      increments_per_cycle;  // of a period of the last stage, or of that stage if it has none
  std::function<void(double share, double wall_time, const std::string& what)> on_progress = {};
  std::function<void(const std::string&)> on_warning = {};  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;                  // set by Ctrl-C: what is complete is saved
};

// A part of the stage that was left to dynamics, since the packing had no equilibrium next to the present
// one.
struct HandOver {
  double from = 0, to = 0;  // (s)
};

// The last stage of a plan without dynamics.
struct FollowedLoad {
  std::filesystem::path directory;
  std::string title;
  std::size_t bodies = 0, degrees_of_freedom = 0;
  double start = 0, end = 0, increment = 0;  // (s)
  double reached = 0;                        // (s) before the end if it was interrupted or failed
  double period = 0;                         // (s) of the stage; 0 without
  std::size_t increments = 0, iterations = 0,
              events = 0;  // quasi-static; contacts that opened, closed, began or ended to slide
  std::vector<HandOver> hand_overs;
  std::size_t dynamic_steps = 0;
  double wall_time = 0, dynamic_wall_time = 0;  // (s) of all the stage, and of its dynamics
  bool interrupted = false;
  std::vector<std::string> warnings;  // "<what>; <cure>"

  double dynamic_time() const {  // (s) of all hand-overs, as far as the load is kept
    double sum = 0;
    for (const HandOver& h : hand_overs) sum += std::max(std::min(h.to, reached) - h.from, 0.0);
    return sum;
  }
};

// Runs the stages of a plan but the last, follows the last one through states of equilibrium
// (response::QuasiStatic), and writes the directory: series/quasi_static.csv, a chart, final_state.h5,
// quasi_static.json. Where there is no equilibrium next to the present one, also at the start, dynamics go on
// until there is. Throws Error (bad_input) before anything is written if the last stage has no duration, a
// law no derivative, or walls are moved otherwise than by stresses and forces; or as a run does.
FollowedLoad follow(const scenario::Plan& plan, const FollowOptions& options);

// Goes on with the interrupted load in options.out, from the end of its last complete cycle (of 40 increments
// of a load without period), to the same bits. options: out, threads, callbacks and stop count. Throws Error
// (bad_input) if it is finished, or if there is no state.
FollowedLoad resume_following(const FollowOptions& options, PluginHost& host);

// The result for people.
std::string text_report(const FollowedLoad& load);

}  // namespace scree::quasi_static
