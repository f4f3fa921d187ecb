#pragma once

#include "box_row.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/spare_room.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/state_transfer.hpp>

namespace scree::quasi_static {

// One course from its start, or from its state, to its last file. The search for equilibrium begins anew with each part, such as a cycle, from
// positions and springs alone, so that a course that goes on from there has the same bits.
class Follower {
 public:
  static constexpr const run::ResultKind& results = run::response_results;

  Follower(const scenario::Plan& plan, const FollowOptions& options, run::RunDirectory& directory);

  Course begin();
  Course resume(const State& state);

 private:
  bool proceeds() const { return !options_.stop || !*options_.stop; }
  // Throws Error if the last stage cannot be followed.
  void check_plan() const;
  // Up to the balance at the beginning of the last stage.
  void find_start();
  void run_stages_before();
  void check_last_stage() const;
  Error interrupted(const std::string& when) const;
  response::QuasiStaticOptions quasi_static_options() const;
  std::unique_ptr<Simulation> simulation_of(const State& state) const;

  // Follows the load after `begin`.
  Course follow(const std::function<void()>& begin);
  std::size_t intervals() const;
  // To the end of an interval, without dynamics where that can be.
  void advance(double time);
  // From where the packing has no equilibrium nearby.
  void hand_over();
  // If the packing that moves has an equilibrium nearby, goes on from there.
  void end_dynamics_at_rest(double time);
  // Keeps the state, and begins the search for equilibrium anew.
  void begin_part();
  void begin_packing(const State& state);
  void begin_dynamics(std::unique_ptr<Simulation> simulation);
  // Adds what the packing has counted.
  void end_packing();

  void sample(const Sample& sample);
  void report() const;
  void warn(const std::string& line);
  void keep_state(State state);
  void write_kept_state();
  void write_final_state();  // from which runs may begin
  void transfer_state(const StateTransfer& state);
  void end_course();
  void check_restored(const StateTransfer& state) const;
  void save(const std::string& status);
  void save_failed();
  double seconds() const;  // of wall time, also before it was interrupted

  const scenario::Plan& plan_;
  const FollowOptions& options_;
  run::RunDirectory& directory_;
  Course course_;
  std::size_t between_states_ = 1;                     // intervals: those of a cycle, if the load has cycles
  std::size_t interval_ = 0;                           // intervals that are done
  std::unique_ptr<Simulation> simulation_, dynamics_;  // from which the packing came; that goes on instead
  std::unique_ptr<response::QuasiStatic> packing_;
  std::unique_ptr<BoxRow> box_;
  std::vector<double> lengths_at_start_;  // (m) of the box, for box_
  std::optional<run::LineFile> series_;
  run::SpareRoom room_;
  std::uint64_t series_bytes_ = 0;  // up to the state that is kept
  std::vector<double> times_, strains_;
  std::optional<State> kept_;  // at the start of the present part, if it is not in the file
  double wall_before_ = 0;     // (s) until it was interrupted
  double last_state_ = 0;      // (s) of wall time
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace scree::quasi_static
