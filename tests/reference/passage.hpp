#pragma once

#include "dormand_prince.hpp"
#include "motion.hpp"

#include <array>
#include <vector>

namespace reference {

// The way of one contact from first touch to its end: smooth pieces of the motion, each integrated up to the
// switch of the law that ends it.
class Passage {
 public:
  struct Settings {
    double approach_speed = 0;  // at first touch
    double tolerance = 0;
    double relaxed_limit = 0;
    std::vector<double> sample_times = {};  // since first touch
  };
  // A state that was asked for, or the last.
  struct Record {
    State state;
    Branch branch;
  };

  Passage(Motion& motion, Settings settings);
  void run();

  const State& state() const { return state_; }
  const std::vector<Record>& records() const { return records_; }
  double pushing_time() const { return pushing_time_; }
  double largest_overlap() const { return largest_overlap_; }
  double remaining_elastic() const { return remaining_elastic_; }
  double energy_residual() const { return energy_residual_; }
  int slides() const { return slides_; }
  int switches() const { return switches_; }
  int steps() const { return steps_; }

 private:
  // What the integration advances in. The forces begin and end with broken powers of time and overlap, which
  // are whole powers of these: opening: time = τ⁴, running: time, closing: overlap = p⁴ with falling p.
  enum class Clock { opening, running, closing };
  // Where a switch of the law lies: each a number that becomes positive there.
  enum Signal { parting, pushing, growing, grip, clipping, sample, signals };
  using Signals = std::array<double, signals>;
  // A part of a step.
  struct Piece {
    double length;
    State end;
  };

  void begin();
  void begin_sliding_or_sticking(State& state, const Instant& now);
  void choose_clock();
  void set_clock(Clock clock, const Instant& now);
  void choose_relaxed();
  void advance();
  State rates(double elapsed, State state) const;
  double time_per_clock(const Instant& now, double elapsed) const;
  double longest_step() const;
  State try_step(const State& first);
  double error(const RungeKuttaStep<std::tuple_size_v<State>>& step) const;
  State error_scales(const State& end) const;
  double direction_weight() const;

  Signals signals_of(const State& state) const;
  int first_positive(const Signals& signals, int except) const;
  Piece piece(const State& first, double length) const;
  Piece first_suspect(const State& first, Piece whole) const;
  Piece locate(const State& first, Piece piece, int& signal) const;
  Piece root(const State& first, Piece upper, int signal) const;
  Piece shrink(const State& first, double lower, double lower_value, Piece upper, int signal) const;
  void settle(const Piece& piece);
  void act(int signal);
  void switch_pushing();
  void switch_grip();
  void jump(State& state, const Instant& before) const;
  void let_spring_go();
  void check_balance();

  Motion& motion_;
  Settings settings_;
  double duration_, force_scale_, overlap_scale_, speed_scale_;
  double first_energy_ = 0;

  State state_{};
  Branch branch_;
  Clock clock_ = Clock::opening;
  double mark_ = 0;  // τ or p at the beginning of the step
  double step_ = 0, closing_begin_ = 0;
  bool ended_ = false;
  int immediate_ = 0;  // switches in succession without a step between them
  std::size_t next_sample_ = 0;

  std::vector<Record> records_;
  double pushing_since_ = 0, pushing_time_ = 0;
  double largest_overlap_ = 0, remaining_elastic_ = 0, energy_residual_ = 0;
  int slides_ = 0, switches_ = 0, steps_ = 0;
};

}  // namespace reference
