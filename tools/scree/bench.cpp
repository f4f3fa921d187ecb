#include "bench.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/median.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>

namespace scree::tool {

namespace {

// A scene that goes on for as long as one likes.
class RepeatedScene {
 public:
  RepeatedScene(const scenario::Plan& plan, const BenchOptions& options) : plan_(plan), options_(options) {
    begin();
  }

  // Wall time of so many steps (s).
  double advance(std::uint64_t steps) {
    double seconds = 0;
    while (steps > 0) {
      if (stages_->finished()) begin();
      const std::uint64_t searches = simulation_->rebuilds();
      const auto start = std::chrono::steady_clock::now();
      steps -= stages_->run(steps, [] { return true; });
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      searches_ += simulation_->rebuilds() - searches;
    }
    return seconds;
  }

  void measure(Profile& profile) { simulation_->measure(profile_ = &profile); }
  const Simulation& simulation() const { return *simulation_; }
  std::uint64_t searches() const { return searches_; }
  std::uint64_t begun() const { return begun_; }  // times

 private:
  void begin() {
    ++begun_;
    simulation_ = run::set_up(plan_, options_.threads, options_.ranks);
    stages_ = std::make_unique<StageRunner>(run::stage_runner(*simulation_, plan_));
    const double h = simulation_->step_length();
    while (!stages_->finished() && simulation_->time() < options_.start - 0.5 * h) {
      const double left = (options_.start - simulation_->time()) / h;
      stages_->run(std::uint64_t(std::min(left + 0.5, 1e15)), [] { return true; });
    }
    if (stages_->finished())
      throw Error(fmt::format("the scene ends at {:g} s; give a smaller --start", simulation_->time()));
    simulation_->measure(profile_);
  }

  const scenario::Plan& plan_;
  const BenchOptions& options_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<StageRunner> stages_;
  Profile* profile_ = nullptr;
  std::uint64_t searches_ = 0, begun_ = 0;
};

// Warms caches and fills lists, with the steps of a repeat, which it returns.
std::uint64_t warm(RepeatedScene& scene, const BenchOptions& options) {
  if (options.steps > 0) {
    scene.advance(options.steps);
    return options.steps;
  }
  // A scene that ends soon takes longer to set up than to run.
  const auto start = std::chrono::steady_clock::now();
  const auto patient = [&] { return std::chrono::steady_clock::now() - start < std::chrono::seconds(2); };
  std::uint64_t steps = 1;
  double wall_time = scene.advance(steps);
  while (wall_time < 0.2 * options.seconds && (patient() || scene.begun() < 2))
    wall_time = scene.advance(steps *= 2);
  if (wall_time < 0.2 * options.seconds) return steps;
  return std::max<std::uint64_t>(1, std::uint64_t(double(steps) * options.seconds / wall_time));
}

}  // namespace

double BenchResult::median() const { return scree::median(s_per_step); }

BenchResult time_steps(const scenario::Plan& plan, const BenchOptions& options) {
  RepeatedScene scene(plan, options);
  BenchResult r{};
  r.steps = warm(scene, options);
  r.first_time = scene.simulation().time();
  for (unsigned n = 0; n < options.repeats; ++n)
    r.s_per_step.push_back(scene.advance(r.steps) / double(r.steps));
  r.searches = scene.searches();
  scene.measure(r.profile);
  scene.advance(r.steps);
  r.searches = scene.searches() - r.searches;
  const Simulation& s = scene.simulation();
  const Footprint footprint = s.footprint();
  r.particles = s.scene().bodies.size();
  r.contacts = footprint.touching_pairs;
  r.bytes_per_particle = footprint.bytes_per_body;
  r.bytes_per_contact = footprint.bytes_per_pair;
  r.listed_pairs = footprint.listed_pairs;
  r.crossing_share = footprint.crossing_share;
  r.foreign_bodies = footprint.foreign_bodies;
  r.bytes_sent = footprint.bytes_sent;
  r.by_graph = footprint.by_graph;
  r.state_hash = s.state_hash();
  return r;
}

}  // namespace scree::tool
