#include "load_study.hpp"
#include "load_warnings.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/stage.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::quasi_static {

void LoadStudy::check_plan() const {
  if (plan_.stages.empty() || !plan_.stages.back().duration)
    throw Error(fmt::format(
        "{}: the last stage is followed, and has no duration; give it one, or cycles and a period",
        plan_.source.string()));
  try {
    response::check_laws(plan_.scene, response::LawsNeeded::all);
  } catch (const Error& error) {
    throw error.at(plan_.source.string());
  }
}

void LoadStudy::check_last_stage() const {
  try {
    if (const auto last = run::set_up_with_last_stage(plan_)) response::loads_of_walls(*last, last->time());
  } catch (const Error& error) {
    throw error.at(plan_.source.string());
  }
}

void LoadStudy::prepare() {
  check_plan();
  std::unique_ptr<Simulation> simulation = run::set_up(plan_, options_.threads);
  if (plan_.stages.size() > 1) check_last_stage();
  for (const std::string& line : simulation->let_go()) session_.warn(line);
  run_stages_before(*simulation);
  session_.restart_watch();
  measure_stage(*simulation);
  surfaces_ = SurfaceColumns(*simulation);
  begin_packing(std::move(simulation));
  if (!session_.proceeds()) throw session_.stopped_before("the load was followed");
  const Sample start = packing_.sample(load_.start);
  lengths_at_start_ = BoxRow::lengths(plan_.scene.dimension, start);
  surfaces_.begin(start);
  box_.emplace(lengths_at_start_, surfaces_);
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
  load_.bodies = simulation.scene().bodies.size();
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

void LoadStudy::open() {
  series_.emplace(session_.directory().add(series_file));
  series_->add(box_->head());
  series_->flush();
}

bool LoadStudy::work() {
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
    draw_charts(chart(), session_.directory());
  } catch (const std::exception& error) {
    session_.warn(fmt::format("the chart was not drawn: {}", error.what()));
  }
  return complete;
}

void LoadStudy::add(const Sample& sample) {
  session_.directory().check_in_place();
  series_->add(box_->line(sample));
  series_->flush();
  times_.push_back(load_.reached = sample.time);
  const BoxRow::Charted charted = box_->charted(sample);
  charted_.push_back(charted.value);
  charted_forces_.push_back(charted.force);
}

void LoadStudy::end_load() {
  packing_.end_search();
  if (const std::string warning = dynamics_warning(load_); !warning.empty()) session_.warn(warning);
}

FollowedLoad follow(const scenario::Plan& plan, const FollowOptions& options) {
  if (options.increments == 0) throw Error("0 increments; give at least 1");
  run::Session session(run::quasi_static_results, plan, run::session_options(options));
  LoadStudy study(plan, options, session);
  session.begin(study);
  return study.result();
}

}  // namespace scree::quasi_static
