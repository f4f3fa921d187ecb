#include <scree/scenario/run.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

#include <scree/error.hpp>
#include <scree/packing/csv.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/run_directory.hpp>
#include <scree/scenario/run_quantities.hpp>
#include <scree/snapshot/load_backend.hpp>

#include "expectations.hpp"
#include "frame_of.hpp"
#include "run_record.hpp"
#include "series.hpp"

namespace scree::scenario {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Scene scene_with_threads(const Plan& plan, unsigned threads) {
  Scene scene = plan.scene;
  scene.threads = threads;
  return scene;
}

std::unique_ptr<Simulation> make_simulation(const Plan& plan, unsigned threads) {
  try {
    return std::make_unique<Simulation>(scene_with_threads(plan, threads));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", plan.source.string(), error.what()));
  }
}

// A probe while the run goes on.
struct ActiveProbe {
  const ProbePlan* plan;
  Probe probe;
  std::unique_ptr<Series> series;
  std::uint64_t interval;  // steps

  bool samples_in(const std::string& stage) const {
    return plan->stages.empty() || std::find(plan->stages.begin(), plan->stages.end(), stage) != plan->stages.end();
  }
};

std::uint64_t steps_in(double duration, double step) { return std::max<std::uint64_t>(1, std::uint64_t(std::llround(duration / step))); }

packing::Packing packing_of(const Simulation& s) {
  packing::Packing all;
  all.dimension = s.dimension();
  all.time = s.time();
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    all.bodies.push_back({.id = b.id, .material = s.scene().materials[b.material], .radius = b.radius, .mass = b.mass,
                          .position = b.position, .velocity = b.velocity, .spin = b.spin});
  }
  return all;
}

class Run {
 public:
  Run(const Plan& plan, const RunOptions& options)
      : plan_(plan), options_(options), directory_(options.out, options.overwrite),
        simulation_(make_simulation(plan, options.threads)) {
    for (const ProbePlan& probe : plan.probes) {
      probes_.push_back({&probe, Probe(probe.parameters, plan.scene.dimension), nullptr,
                         steps_in(probe.every, simulation_->step_length())});
      probes_.back().probe.check(SimulationView(*simulation_, false).get());
    }
    if (plan.snapshot.any()) backend_ = snapshot::load_backend();
    box_ = scene_box(*simulation_);
    result_.directory = directory_.path();
  }

  RunResult execute() {
    directory_.create();
    directory_.write_file("scenario.toml", plan_.resolved_text);
    for (ActiveProbe& p : probes_)
      p.series = std::make_unique<Series>(directory_.series() / (p.plan->name + ".csv"), p.probe.names(), p.probe.units());
    record("running", "");
    try {
      loop();
    } catch (const Error& error) {
      finish_timing();
      save_what_there_is();
      record("failed", error.what());
      throw;
    }
    finish_timing();
    save_what_there_is();
    draw_charts();
    judge();
    record(result_.interrupted ? "interrupted" : "finished", "");
    return result_;
  }

 private:
  void loop() {
    started_ = Clock::now();
    StageRunner runner(*simulation_, plan_.stages);
    std::size_t stage = 0;
    std::uint64_t stage_began = 0;
    observe(runner.stages()[stage].name, 0);
    while (!runner.finished()) {
      if (options_.stop && *options_.stop) {
        result_.interrupted = true;
        break;
      }
      runner.step();
      observe(runner.stages()[stage].name, simulation_->steps() - stage_began);
      if (runner.current() != stage && !runner.finished()) {
        stage = runner.current();
        stage_began = simulation_->steps();
        observe(runner.stages()[stage].name, 0);
      }
      report_progress(runner);
    }
  }

  // Samples and pictures that are due so many steps after the beginning of a stage.
  void observe(const std::string& stage, std::uint64_t steps) {
    bool contacts = false, due = false;
    for (const ActiveProbe& p : probes_)
      if (steps % p.interval == 0 && p.samples_in(stage)) due = true, contacts |= p.probe.needs_contacts();
    if (due) {
      const SimulationView view(*simulation_, contacts);
      for (ActiveProbe& p : probes_)
        if (steps % p.interval == 0 && p.samples_in(stage)) sample(p, view);
    }
    if (backend_) take_pictures(steps);
  }

  void sample(ActiveProbe& p, const SimulationView& view) {
    // The last row of a stage is the first of the next.
    if (p.series->rows() > 0 && p.series->column("time").back() == simulation_->time()) return;
    p.series->add(simulation_->time(), p.probe.sample(view.get()));
  }

  void take_pictures(std::uint64_t steps) {
    const double h = simulation_->step_length();
    const auto due = [&](const std::optional<double>& every) { return every && steps % steps_in(*every, h) == 0; };
    if (due(plan_.snapshot.every)) write_snapshot();
    if (due(plan_.snapshot.image_every)) write_image();
  }

  void write_snapshot() {
    if (simulation_->steps() == last_snapshot_) return;
    last_snapshot_ = simulation_->steps();
    backend_->write_frame(frame_of(*simulation_, plan_.title, box_), directory_.snapshots());
  }

  void write_image() {
    if (simulation_->steps() == last_image_) return;
    last_image_ = simulation_->steps();
    snapshot::RenderOptions options;
    options.width = plan_.snapshot.width;
    options.height = plan_.snapshot.height;
    options.color_by = plan_.snapshot.color_by;
    options.view = plan_.snapshot.view;
    options.show_contacts = plan_.snapshot.show_contacts;
    backend_->render(frame_of(*simulation_, plan_.title, box_), options,
                     directory_.images() / fmt::format("frame_{:010}.png", simulation_->steps()));
  }

  void report_progress(const StageRunner& runner) {
    constexpr std::uint64_t steps_between_looks = 32;
    if (!options_.on_progress || simulation_->steps() % steps_between_looks) return;
    const double wall = seconds_since(started_);
    if (wall - last_report_ < 0.2) return;
    last_report_ = wall;
    for (ActiveProbe& p : probes_) p.series->flush();
    const std::string stage = runner.finished() ? "" : runner.stages()[runner.current()].name;
    options_.on_progress({runner.progress(), wall, simulation_->time(), stage});
  }

  void finish_timing() {
    result_.wall = seconds_since(started_);
    const double work = double(simulation_->steps()) * double(simulation_->particles().size());
    result_.particle_steps_per_second = result_.wall > 0 ? work / result_.wall : 0;
  }

  // The last state and all rows, whatever ended the run.
  void save_what_there_is() {
    for (ActiveProbe& p : probes_) p.series->flush();
    if (backend_ && plan_.snapshot.every) write_snapshot();
    if (backend_ && plan_.snapshot.image_every) write_image();
    const packing::Packing last = packing_of(*simulation_);
    const bool finite = std::all_of(last.bodies.begin(), last.bodies.end(), [](const packing::Body& b) {
      return std::isfinite(norm(b.position)) && std::isfinite(norm(b.velocity)) && std::isfinite(norm(b.spin));
    });
    if (!last.bodies.empty() && finite) packing::write_csv(last, directory_.path() / "final_packing.csv");
  }

  const Series& series_of(const std::string& probe) const {
    for (const ActiveProbe& p : probes_)
      if (p.plan->name == probe) return *p.series;
    throw Error(fmt::format("no probe '{}'", probe), ExitStatus::failure);
  }

  void draw_charts() {
    for (const ChartPlan& plan : plan_.charts) {
      snapshot::ChartSpec spec;
      spec.title = plan.title;
      spec.x_label = plan.x_label;
      spec.y_label = plan.y_label;
      spec.log_x = plan.log_x;
      spec.log_y = plan.log_y;
      for (const CurvePlan& curve : plan.curves) {
        const Series& series = series_of(curve.probe);
        if (series.rows() > 0) spec.series.push_back({curve.name, series.column(curve.x), series.column(curve.y)});
      }
      if (spec.series.empty()) continue;
      if (!backend_) backend_ = snapshot::load_backend();
      try {
        backend_->chart(spec, directory_.charts() / (plan.name + ".png"));
      } catch (const Error& error) {
        if (options_.on_message) options_.on_message(fmt::format("chart '{}' was not drawn: {}", plan.name, error.what()));
      }
    }
  }

  void judge() {
    result_.quantities = run_quantities(*simulation_);
    if (result_.interrupted) return;
    for (const Expectation& e : plan_.expectations)
      result_.verdicts.push_back(judge_expectation(e, result_.quantities, [&](const std::string& probe, const std::string& column) {
        return series_of(probe).column(column);
      }));
  }

  void record(const std::string& status, const std::string& error) {
    result_.quantities = run_quantities(*simulation_);
    result_.state_hash = simulation_->state_hash();
    directory_.write_file("run.json", run_record(plan_, options_, result_, *simulation_, status, error));
  }

  const Plan& plan_;
  const RunOptions& options_;
  RunDirectory directory_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<ActiveProbe> probes_;
  std::shared_ptr<snapshot::SnapshotBackend> backend_;
  SceneBox box_;
  RunResult result_;
  Clock::time_point started_ = Clock::now();
  double last_report_ = 0;
  std::uint64_t last_snapshot_ = ~0ull, last_image_ = ~0ull;
};

}  // namespace

RunResult run(const Plan& plan, const RunOptions& options) { return Run(plan, options).execute(); }

}  // namespace scree::scenario
