#pragma once

#include "box_row.hpp"
#include "load_report.hpp"
#include "loaded_packing.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/session.hpp>

namespace scree::quasi_static {

// The study of a load, from its start (follow.cpp) or from a state (resume.cpp) to its last file.
class LoadStudy : public run::Study {
 public:
  LoadStudy(const scenario::Plan& plan, const FollowOptions& options, run::Session& session)
      : plan_(plan),
        options_(options),
        session_(session),
        packing_(
            plan, options.threads, [&session] { return session.proceeds(); }, load_) {
    load_.title = plan.heading();
  }

  // The load in intervals of an increment each, with a row of the series at the end of each. A part is a
  // cycle, or some intervals of a load without cycles: between parts the search for equilibrium begins anew,
  // so that a study that goes on from there has the same bits.
  bool work() override;

  // Runs the stages before, and finds the balance at the start of the last one.
  void prepare() override;
  void open() override;
  void restore(const State& state) override;
  void reopen() override { series_->cut(); }

  void end_failed() override { end_load(); }
  void save_failed() override { draw_charts(chart(), session_.directory()); }

  void transfer(const StateTransfer& state) override;

  nlohmann::ordered_json record() override {
    load_.wall_time = session_.wall_time();
    return record_of(load_);
  }
  // A load that goes on from a state knows its increment alone.
  nlohmann::ordered_json options() const override {
    const double whole = load_.period > 0 ? load_.period : load_.end - load_.start;
    const bool begun = load_.increment > 0;
    return {{"increments", begun ? std::llround(whole / load_.increment) : options_.increments}};
  }

  FollowedLoad result() {
    load_.directory = session_.directory().path();
    load_.interrupted = session_.interrupted();
    load_.warnings = session_.warnings();
    return std::move(load_);
  }

 private:
  static constexpr const char* series_file = "series/quasi_static.csv";

  // Throws Error if the last stage cannot be followed.
  void check_plan() const;
  // What can be told of it before the stages have run.
  void check_last_stage() const;
  void check_restored(const StateTransfer& state) const;

  void run_stages_before(Simulation& simulation) const;
  void measure_stage(const Simulation& simulation);
  void begin_packing(std::unique_ptr<Simulation> simulation);

  std::size_t intervals() const {
    return std::size_t(std::ceil((load_.end - load_.start) / load_.increment - 1e-9));
  }
  double end_of(std::size_t interval) const {
    return interval < intervals() ? load_.start + double(interval) * load_.increment : load_.end;
  }

  void begin_part() {
    packing_.begin_part([this](const State& state) {
      series_bytes_ = series_->bytes();
      session_.keep(state, load_.reached);
    });
  }

  ChartedLoad chart() const {
    return {load_, times_, charted_, charted_forces_, box_ ? box_->charted_surface() : ""};
  }
  void end_load();
  void add(const Sample& sample);

  const scenario::Plan& plan_;
  const FollowOptions& options_;
  run::Session& session_;
  FollowedLoad load_;
  LoadedPacking packing_;
  std::size_t intervals_in_part_ = 1, interval_ = 0;  // interval_: those that are done
  std::vector<double> lengths_at_start_;              // (m) of the box, for box_
  SurfaceColumns surfaces_;                           // that forces move
  std::optional<BoxRow> box_;
  std::optional<run::LineFile> series_;
  std::uint64_t series_bytes_ = 0;                        // up to the state that is kept
  std::vector<double> times_, charted_, charted_forces_;  // see BoxRow::charted()
};

}  // namespace scree::quasi_static
