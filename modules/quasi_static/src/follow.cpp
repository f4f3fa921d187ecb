#include "box_row.hpp"
#include "course_files.hpp"
#include "load_warnings.hpp"
#include "sample.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/try_each.hpp>
#include <scree/quasi_static/follow.hpp>
#include <scree/response/quasi_static.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/set_up.hpp>
#include <scree/stage.hpp>

namespace scree::quasi_static {

namespace {

using response::QuasiStatic;
using run::RunDirectory;
using Clock = std::chrono::steady_clock;

// Steps of the stages before that are taken at once.
constexpr std::uint64_t steps_at_once = 1000;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Period of the last stage (s); 0 if it has none.
double period_of(const scenario::Plan& plan) {
  const auto document = document::Document::parse(plan.resolved_text, plan.source.string());
  const auto stages = document.root().tables("stage");
  if (stages.empty() || !stages.back().is_number("period")) return 0;
  return stages.back().number("period", document::Range::positive("s"));
}

class Follower {
 public:
  Follower(const scenario::Plan& plan, const FollowOptions& options, RunDirectory& directory)
      : plan_(plan), options_(options), directory_(directory) {
    course_.title = plan.title.empty() ? plan.source.stem().string() : plan.title;
    course_.directory = directory.path();
    course_.scenario = plan.resolved_text;
    course_.inputs = run::hashes_of(plan.files);
  }

  Course take() {
    begin();
    directory_.create();
    try {
      write_record("running", course_, directory_);
      directory_.write_file("scenario.toml", plan_.text_for_any_folder);
      series_.emplace(directory_.add("series/quasi_static.csv"));
      series_->add(box_->head());
      sample(dynamics_ ? sample_of(*dynamics_, course_.start) : sample_of(*packing_, course_.start));
      const auto intervals = std::size_t(std::ceil((course_.end - course_.start) / course_.increment - 1e-9));
      for (std::size_t k = 1; k <= intervals && proceeds(); ++k) {
        advance(k < intervals ? course_.start + double(k) * course_.increment : course_.end);
        report(double(k) / double(intervals));
      }
    } catch (const Error& error) {
      course_.error = error.what();
      files::try_each([&] { save("failed"); });
      files::rethrow_as_failure(error);
    } catch (const std::exception& error) {  // such as of memory
      course_.error = error.what();
      files::try_each([&] { save("failed"); });
      throw;
    }
    course_.interrupted = !proceeds();
    save(course_.interrupted ? "interrupted" : "finished");
    return std::move(course_);
  }

 private:
  bool proceeds() const { return !options_.stop || !*options_.stop; }

  // Up to the balance at the beginning of the last stage.
  void begin() {
    if (plan_.stages.empty() || !plan_.stages.back().duration)
      throw Error(fmt::format(
          "{}: the last stage is followed, and has no duration; give it one, or cycles and a period",
          plan_.source.string()));
    if (plan_.scene.precision != Precision::double_precision)
      throw Error(fmt::format("{}: a quasi-static load takes double precision; leave time.precision out",
                              plan_.source.string()));
    simulation_ = run::set_up(plan_, options_.threads);
    StageRunner stages(*simulation_, plan_.stages);
    while (stages.current() + 1 < plan_.stages.size()) {
      stages.run(steps_at_once, [this] { return proceeds(); });
      if (!proceeds()) throw interrupted("before the stages had ended");
      if (options_.on_progress) options_.on_progress(0, 0, plan_.stages[stages.current()].name);
    }
    began_ = Clock::now();
    course_.period = period_of(plan_);
    course_.start = course_.reached = simulation_->time();
    course_.end = course_.start + *plan_.stages.back().duration;
    const double whole = course_.period > 0 ? course_.period : *plan_.stages.back().duration;
    course_.increment = whole / options_.increments;
    course_.bodies = simulation_->particles().size();
    try {
      for (const std::string& warning : load_warnings(*simulation_, course_, options_.increments))
        warn(warning);
      packing_ = std::make_unique<QuasiStatic>(*simulation_, quasi_static_options());
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()), error.status());
    }
    course_.degrees_of_freedom = packing_->degrees_of_freedom();
    const bool balanced = packing_->advance(course_.start);
    if (!proceeds()) throw interrupted("before the load was followed");
    box_ = std::make_unique<BoxRow>(simulation_->dimension(),
                                    balanced ? packing_->planes() : simulation_->planes());
    if (!balanced) begin_with_dynamics();
  }

  Error interrupted(const std::string& when) const {
    return Error(fmt::format("{}: interrupted {}; nothing was written, give the same call again",
                             plan_.source.string(), when),
                 ExitStatus::interrupted);
  }

  // Without equilibrium at the start: the load jumps there, or the packing has not come to rest.
  void begin_with_dynamics() {
    warn(
        "the packing is not in balance with the loads at the start of the last stage, and dynamics go on from there; begin the "
        "loads with their present values, and let the packing come to rest in the stage before (until)");
    end_packing();
    dynamics_ = std::move(simulation_);
    course_.hand_overs.push_back({course_.start, course_.start});
  }

  response::QuasiStaticOptions quasi_static_options() const {
    return {.longest_increment = course_.increment, .proceed = [this] { return proceeds(); }};
  }

  // To a time (s), without dynamics where that can be.
  void advance(double time) {
    if (!dynamics_ && packing_->advance(time)) {
      sample(sample_of(*packing_, time));
      return;
    }
    if (!proceeds()) return;
    if (!dynamics_) hand_over();
    const Clock::time_point begin = Clock::now();
    course_.dynamic_steps +=
        dynamics_->run(std::uint64_t(std::llround((time - dynamics_->time()) / dynamics_->step_length())),
                       [this] { return proceeds(); });
    course_.hand_overs.back().to = dynamics_->time();
    course_.dynamic_wall += seconds_since(begin);
    if (proceeds()) take_back(time);
  }

  // From where the packing has no equilibrium nearby.
  void hand_over() {
    course_.hand_overs.push_back({packing_->time(), packing_->time()});
    Scene scene = scene_in_stage(plan_.scene, plan_.stages, plan_.stages.size() - 1);
    scene.threads = options_.threads;
    dynamics_ = std::make_unique<Simulation>(scene, packing_->state());
    end_packing();
  }

  // If the packing that moves has an equilibrium nearby, goes on from there.
  void take_back(double time) {
    auto packing = std::make_unique<QuasiStatic>(*dynamics_, quasi_static_options());
    const bool balanced = packing->advance(std::max(time, dynamics_->time()));
    if (proceeds()) {
      Sample reached = balanced ? sample_of(*packing, time) : sample_of(*dynamics_, time);
      reached.dynamic = true;
      sample(reached);
    }
    packing_ = std::move(packing);
    if (balanced && proceeds())
      simulation_ = std::move(dynamics_);
    else
      end_packing();
  }

  // Adds what the packing has counted.
  void end_packing() {
    if (!packing_) return;
    course_.increments += packing_->counts().increments;
    course_.iterations += packing_->counts().iterations;
    course_.events += packing_->counts().events;
    packing_.reset();
  }

  void sample(const Sample& sample) {
    series_->add(box_->line(sample));
    series_->flush();
    times_.push_back(course_.reached = sample.time);
    strains_.push_back(box_->deviatoric_strain(sample));
  }

  void report(double share) const {
    if (options_.on_progress) options_.on_progress(share, seconds_since(began_), "quasi-static");
  }

  void warn(const std::string& line) {
    course_.warnings.push_back(line);
    if (options_.on_warning) options_.on_warning(line);
  }

  void save(const std::string& status) {
    end_packing();
    course_.wall = seconds_since(began_);
    if (course_.dynamic_time() > 0.5 * (course_.reached - course_.start))
      warn(
          "dynamics took more than half of the time: the packing has no equilibrium nearby for long; run it with scree run, or "
          "compress it further");
    try {
      draw_chart(course_, times_, strains_, directory_);
    } catch (const std::exception& error) {
      warn(fmt::format("the chart was not drawn: {}", error.what()));
    }
    write_record(status, course_, directory_);
  }

  const scenario::Plan& plan_;
  const FollowOptions& options_;
  RunDirectory& directory_;
  Course course_;
  std::unique_ptr<Simulation> simulation_, dynamics_;  // from which the packing came; that goes on instead
  std::unique_ptr<QuasiStatic> packing_;
  std::unique_ptr<BoxRow> box_;
  std::optional<run::LineFile> series_;
  std::vector<double> times_, strains_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

Course follow(const scenario::Plan& plan, const FollowOptions& options) {
  if (options.increments == 0) throw Error("0 increments; give at least 1");
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                                    RunDirectory::Kind::response);
  return Follower(plan, options, directory).take();
}

}  // namespace scree::quasi_static
