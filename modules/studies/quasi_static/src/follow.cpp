#include "box_row.hpp"
#include "load_report.hpp"
#include "load_warnings.hpp"
#include "loaded_packing.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/run_stages.hpp>
#include <scree/run/session.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/stage.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::quasi_static {

namespace {

constexpr const char* series_file = "series/quasi_static.csv";

// The study of a load, from its start or from a state to its last file.
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
  bool work() override {
    if (times_.empty()) {
      add(packing_.sample(load_.start));
      begin_part();
    }
    while (interval_ < intervals() && session_.proceeds()) {
      if (const auto sample = packing_.advance(end_of(interval_ + 1))) add(*sample);
      if (!session_.proceeds()) break;
      ++interval_;
      if (interval_ % intervals_in_part_ == 0 && interval_ < intervals()) begin_part();
      session_.report(double(interval_) / double(intervals()), "quasi-static");
    }
    const bool complete = session_.proceeds();
    if (complete && plan_.checkpoint.final_state)
      state_file::write_state(session_.directory().add("final_state.h5"), packing_.state());
    end_load();
    try {
      draw_chart(load_, times_, strains_, session_.directory());
    } catch (const std::exception& error) {
      session_.warn(fmt::format("the chart was not drawn: {}", error.what()));
    }
    return complete;
  }

  // Runs the stages before, and finds the balance at the start of the last one.
  void prepare() override {
    check_plan();
    std::unique_ptr<Simulation> simulation = run::set_up(plan_, options_.threads);
    if (plan_.stages.size() > 1) check_last_stage();
    for (const std::string& line : simulation->let_go()) session_.warn(line);
    run_stages_before(*simulation);
    session_.restart_watch();
    measure_stage(*simulation);
    begin_packing(std::move(simulation));
    if (!session_.proceeds()) throw session_.stopped_before("the load was followed");
    lengths_at_start_ = BoxRow::lengths(plan_.scene.dimension, packing_.sample(load_.start).planes);
    box_.emplace(lengths_at_start_);
  }

  void open() override {
    series_.emplace(session_.directory().add(series_file));
    series_->add(box_->head());
    series_->flush();
  }

  void restore(const State& state) override {
    check_plan();
    const StateTransfer from = StateTransfer::restoring_from(state).below(run::quasi_static_results.group);
    session_.transfer(from);
    check_restored(from);
    box_.emplace(lengths_at_start_);
    packing_.begin(state, from.has("moves"));
    series_.emplace(session_.directory().path() / series_file, series_bytes_);
  }

  void reopen() override { series_->cut(); }

  void end_failed() override { end_load(); }
  void save_failed() override { draw_chart(load_, times_, strains_, session_.directory()); }

  void transfer(const StateTransfer& state) override;

  nlohmann::ordered_json record() override {
    load_.wall = session_.wall();
    return record_of(load_);
  }

  FollowedLoad result() {
    load_.directory = session_.directory().path();
    load_.interrupted = session_.interrupted();
    load_.warnings = session_.warnings();
    return std::move(load_);
  }

 private:
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

  void end_load() {
    packing_.end_search();
    if (const std::string warning = dynamics_warning(load_); !warning.empty()) session_.warn(warning);
  }

  void add(const Sample& sample) {
    session_.directory().check_in_place();
    series_->add(box_->line(sample));
    series_->flush();
    times_.push_back(load_.reached = sample.time);
    strains_.push_back(box_->deviatoric_strain(sample));
  }

  const scenario::Plan& plan_;
  const FollowOptions& options_;
  run::Session& session_;
  FollowedLoad load_;
  LoadedPacking packing_;
  std::size_t intervals_in_part_ = 1, interval_ = 0;  // interval_: those that are done
  std::vector<double> lengths_at_start_;              // (m) of the box, for box_
  std::optional<BoxRow> box_;
  std::optional<run::LineFile> series_;
  std::uint64_t series_bytes_ = 0;  // up to the state that is kept
  std::vector<double> times_, strains_;
};

void LoadStudy::check_plan() const {
  if (plan_.stages.empty() || !plan_.stages.back().duration)
    throw Error(fmt::format(
        "{}: the last stage is followed, and has no duration; give it one, or cycles and a period",
        plan_.source.string()));
  if (plan_.scene.precision != Precision::double_precision)
    throw Error(fmt::format("{}: a quasi-static load takes double precision; leave time.precision out",
                            plan_.source.string()));
}

void LoadStudy::check_last_stage() const {
  try {
    response::check_laws(plan_.scene, response::LawsNeeded::all);
    if (const auto last = run::set_up_with_last_stage(plan_)) response::loads_of_walls(*last, last->time());
  } catch (const Error& error) {
    throw error.at(plan_.source.string());
  }
}

void LoadStudy::run_stages_before(Simulation& simulation) const {
  StageRunner stages = run::stage_runner(simulation, plan_);
  const bool ended = run::run_stages(
      stages, plan_.stages.size() - 1, [this] { return session_.proceeds(); },
      [this](double, const std::string& stage) { session_.report(0, stage); });
  if (!ended) throw session_.stopped_before("the stages had ended");
}

void LoadStudy::measure_stage(const Simulation& simulation) {
  const Stage& stage = plan_.stages.back();
  load_.period = stage.period;
  load_.start = load_.reached = simulation.time();
  load_.end = load_.start + *stage.duration;
  const bool cyclic = load_.period > 0;
  load_.increment = (cyclic ? load_.period : *stage.duration) / options_.increments;
  intervals_in_part_ = cyclic ? options_.increments : FollowOptions::increments_per_cycle;
  load_.bodies = simulation.particles().size();
}

void LoadStudy::begin_packing(std::unique_ptr<Simulation> simulation) {
  try {
    for (const std::string& warning : load_warnings(*simulation, load_, options_.increments))
      session_.warn(warning);
    if (packing_.begin(std::move(simulation))) return;
  } catch (const Error& error) {
    throw error.at(plan_.source.string());
  }
  // The load jumps there, or the packing has not come to rest.
  session_.warn(
      "the packing is not in balance with the loads at the start of the last stage, and dynamics go on from there; begin the "
      "loads with their present values, and let the packing come to rest in the stage before (until)");
}

void transfer_hand_overs(const StateTransfer& state, std::vector<HandOver>& all) {
  std::vector<double> from, to;
  for (const HandOver& h : all) from.push_back(h.from), to.push_back(h.to);
  state.rows("from", "s", from);
  to.resize(from.size());
  state.sized_rows("to", "s", to);
  all.resize(from.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = {from[k], to[k]};
}

void transfer_count(const StateTransfer& state, const char* name, std::size_t& number) {
  std::uint64_t stored = number;
  state.value(name, "1", stored);
  number = std::size_t(stored);
}

void LoadStudy::transfer(const StateTransfer& state) {
  transfer_count(state, "intervals_done", interval_);
  transfer_count(state, "intervals_between_states", intervals_in_part_);
  state.value("series_bytes", "1", series_bytes_);
  for (const auto& [name, time] : {std::pair{"start", &load_.start},
                                   {"end", &load_.end},
                                   {"reached", &load_.reached},
                                   {"increment", &load_.increment},
                                   {"period", &load_.period},
                                   {"dynamic_wall", &load_.dynamic_wall}})
    state.value(name, "s", *time);
  for (const auto& [name, number] : {std::pair{"bodies", &load_.bodies},
                                     {"degrees_of_freedom", &load_.degrees_of_freedom},
                                     {"increments", &load_.increments},
                                     {"iterations", &load_.iterations},
                                     {"events", &load_.events},
                                     {"dynamic_steps", &load_.dynamic_steps}})
    transfer_count(state, name, *number);
  transfer_hand_overs(state.below("hand_overs"), load_.hand_overs);
  state.rows("lengths_at_start", "m", lengths_at_start_);
  state.rows("times", "s", times_);
  strains_.resize(times_.size());
  state.sized_rows("strains", "1", strains_, 1, stored::any);  // NaN: the box is not known along x and y
  if (bool moves = packing_.moves(); moves && !state.restoring()) state.value("moves", "1", moves);
}

// Intervals are counted, and a packing that moves was handed over.
void LoadStudy::check_restored(const StateTransfer& state) const {
  constexpr double most_intervals = 1e9;
  if (intervals_in_part_ == 0) state.refuse("intervals_between_states", "is 0");
  if (!(load_.increment > 0 && load_.end > load_.start &&
        (load_.end - load_.start) / load_.increment < most_intervals))
    state.refuse("increment", "does not divide the time from 'start' to 'end'");
  if (interval_ > intervals()) state.refuse("intervals_done", "is larger than the number of intervals");
  if (state.has("moves") && load_.hand_overs.empty()) state.refuse("hand_overs/from", "has none");
  if (lengths_at_start_.size() > std::size_t(plan_.scene.dimension))
    state.refuse("lengths_at_start", "has a length for more axes than the scene has");
}

}  // namespace

FollowedLoad follow(const scenario::Plan& plan, const FollowOptions& options) {
  if (options.increments == 0) throw Error("0 increments; give at least 1");
  run::Session session(run::quasi_static_results, plan, run::session_options(options));
  LoadStudy study(plan, options, session);
  session.begin(study);
  return study.result();
}

FollowedLoad resume_following(const FollowOptions& options, PluginHost& host) {
  return files::in_place([&] {
    run::Unfinished from =
        run::unfinished_in(options.out, run::quasi_static_results, host, options.on_warning);
    run::Session session(run::quasi_static_results, from.plan, run::session_options(options),
                         std::move(from.directory));
    LoadStudy study(from.plan, options, session);
    session.resume(study, from.state, from.file);
    return study.result();
  });
}

}  // namespace scree::quasi_static
