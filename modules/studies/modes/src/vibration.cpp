#include "mode_checks.hpp"
#include "mode_picture.hpp"
#include "mode_properties.hpp"
#include "vibration_files.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/modes/vibration.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/response/rest.hpp>
#include <scree/run/session.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/stage_loop.hpp>

namespace scree::modes {

namespace {

// Seconds of each part over those of a factorisation, for the time left.
constexpr double cost_of_modes = 12, cost_of_a_mode = 0.6, cost_of_constants = 8;

class VibrationStudy : public run::Study {
 public:
  VibrationStudy(const scenario::Plan& plan, const VibrationOptions& options, run::Session& session)
      : plan_(plan), options_(options), session_(session), directory_(session.directory()) {
    assembly_.fewest_contacts = options.fewest_contacts;
    assembly_.at_limit = options.contacts_slide ? response::AtLimit::slide : response::AtLimit::stick;
    result_.title = plan.heading();
    result_.dimension = plan.scene.dimension;
  }

  // Runs the stages, and linearises the packing at their end: what cannot be done with it is refused before
  // anything is written.
  void prepare() override {
    simulation_ = run::set_up(plan_, options_.threads);
    check_plan();
    for (const std::string& line : simulation_->let_go()) session_.warn(line);
    StageRunner stages = run::stage_runner(*simulation_, plan_);
    if (!session_.run_stages(stages, plan_.stages.size()))
      throw session_.stopped_before("the stages had ended");
    session_.restart_watch();
    linearise();
    describe();
  }

  // Each part that is asked for; tables are written after each.
  bool work() override {
    const response::UndampedSystem undamped(*system_);
    result_.asymmetry = undamped.asymmetry();
    check_frequencies(undamped);
    take("modes", cost_of_modes + cost_of_a_mode * options_.modes, [&] { take_modes(undamped); });
    if (options_.elastic) take("elastic", cost_of_constants, [&] { take_constants(); });
    if (options_.loads) take("loads", cost_of_constants, [&] { take_loads(); });
    if (options_.density > 0) take("density", options_.density, [&] { take_density(undamped); });
    write_tables(result_, directory_);
    try_to_draw("charts", [&] { draw_charts(result_, directory_); });
    return session_.proceeds();
  }

  bool has_results() const override { return !result_.modes.empty(); }
  void save_failed() override { write_tables(result_, directory_); }
  nlohmann::ordered_json record() override { return record_of(result_); }
  nlohmann::ordered_json options() const override { return json_of(options_); }

  Vibration result() {
    result_.directory = directory_.path();
    result_.interrupted = session_.interrupted();
    result_.warnings = session_.warnings();
    return std::move(result_);
  }

 private:
  // What cannot be done with this plan is refused before a step is taken.
  void check_plan() const {
    if (!options_.pictures.empty() && !pictures::has_pictures())
      throw Error(
          fmt::format("{}; {}, or leave --picture out", pictures::no_pictures, pictures::no_pictures_cure));
    try {
      check_density(options_);
      response::check_laws(plan_.scene, response::LawsNeeded::any);
      if (options_.elastic) response::wall_pair(*simulation_);
      const auto last = options_.loads ? run::set_up_with_last_stage(plan_) : nullptr;
      if (last) response::check_loaded_walls(*last);
    } catch (const Error& error) {
      throw error.at(plan_.source.string());
    }
  }

  // The equilibrium nearby takes the place of a packing that is not at rest.
  void linearise() {
    try {
      response::Rest rest =
          response::rest_of(*simulation_, assembly_, [this] { return session_.proceeds(); });
      if (rest.equilibrium) simulation_ = std::move(rest.equilibrium);
      if (!rest.warning.empty()) session_.warn(rest.warning);
      system_.emplace(response::assemble(*simulation_, assembly_));
    } catch (const Error& error) {
      throw error.at(plan_.source.string());
    }
  }

  void describe() {
    const Particles& p = simulation_->particles();
    for (std::size_t i = 0; i < p.size(); ++i) result_.names.push_back(p.id[i]);
    for (std::size_t w = 0; w < system_->freedom.walls(); ++w)
      result_.walls.push_back(simulation_->wall_name(w));
    for (const std::uint32_t i : system_->rattlers) result_.rattlers.push_back(result_.names[i]);
    result_.bodies = p.size() - system_->rattlers.size() - simulation_->footprint().fixed_bodies;
    result_.contacts = simulation_->contact_list().size();
    result_.degrees_of_freedom = std::size_t(system_->freedom.size());
    if (system_->one_way_contacts > 0) session_.warn(response::one_way_warning(system_->one_way_contacts));
  }

  void check_frequencies(const response::UndampedSystem& undamped) const {
    try {
      check_search(undamped, options_);
    } catch (const Error& error) {
      throw error.at(plan_.source.string(), ExitStatus::bad_input);
    }
  }

  // share: of the present part.
  void report(double share, const std::string& what) const {
    const double all = cost_of_modes + cost_of_a_mode * options_.modes +
                       (options_.elastic ? cost_of_constants : 0) + (options_.loads ? cost_of_constants : 0) +
                       options_.density;
    session_.report(std::min(1.0, (done_ + share * part_) / all), what);
  }

  template <class Work>
  void take(const char* name, double cost, const Work& work) {
    if (!session_.proceeds()) return;
    part_ = cost;
    const double start = session_.wall_time();
    work();
    result_.seconds.emplace_back(name, session_.wall_time() - start);
    write_tables(result_, directory_);
    done_ += cost;
  }

  void take_modes(const response::UndampedSystem& undamped) {
    const response::FoundModes found = find_modes(
        undamped, {.count = options_.modes,
                   .near_hz = options_.near_hz,
                   .proceed = [this] { return session_.proceeds(); },
                   .on_progress = [this](double share, const std::string& what) { report(share, what); }});
    result_.unstable = found.unstable, result_.floppy = found.floppy;
    result_.counted = found.counted, result_.complete = found.complete;
    result_.modes = properties_of(found, *system_);
    result_.floppy_bodies = floppy_bodies(found, *system_);
    if (session_.proceeds())
      for (const std::string& warning :
           mode_warnings(result_, found.of_full_stiffness, options_.residual_limit))
        session_.warn(warning);
    if (!found.certain)
      session_.warn(response::uncertain_warning("the numbers of unstable, floppy and found modes"));
    for (const unsigned number : options_.pictures) draw(found, number);
  }

  void draw(const response::FoundModes& found, unsigned number) {
    const std::size_t m = found.first_vibrating + number - 1;
    if (m >= result_.modes.size()) {
      if (session_.proceeds())
        session_.warn(fmt::format(
            "there is no mode {}, of which a picture was asked for; ask for more --modes", number));
      return;
    }
    const std::string name = fmt::format("images/mode_{}.png", number);
    try_to_draw(name, [&] {
      draw_mode(*simulation_, system_->freedom, found.shape.col(Eigen::Index(m)),
                fmt::format("{}: mode {}, {:.6g} Hz", result_.title, number, result_.modes[m].frequency_hz),
                options_.view, directory_.add(name));
      result_.pictures.push_back(name);
    });
  }

  // What was found stays without its pictures.
  template <class Draw>
  void try_to_draw(const std::string& name, const Draw& draw) {
    try {
      draw();
    } catch (const std::exception& error) {
      session_.warn(fmt::format("{} was not drawn: {}", name, error.what()));
    }
  }

  void take_constants() {
    report(0, "elastic constants");
    try {
      result_.elastic =
          response::elastic_moduli(*simulation_, assembly_, [this] { return session_.proceeds(); });
    } catch (const Error& error) {
      if (error.status() == ExitStatus::interrupted) return;
      session_.warn(error.what());
    }
  }

  void take_loads() {
    report(0, "loads on walls");
    try {
      result_.loads =
          response::load_responses(*simulation_, assembly_, [this] { return session_.proceeds(); });
    } catch (const Error& error) {
      if (error.status() == ExitStatus::interrupted) return;
      session_.warn(error.what());
    }
    for (const response::LoadResponse& load : result_.loads)
      if (!(load.residual <= response::LoadResponse::largest_residual))
        session_.warn(fmt::format(
            "a load on {} drives a floppy mode, so that its response is not all there is (residual {:.1g}); compress the "
            "packing further, or leave --loads out",
            result_.walls[load.wall], load.residual));
  }

  void take_density(const response::UndampedSystem& undamped) {
    result_.density = density_of_states(
        undamped, result_.bodies,
        {.points = options_.density,
         .to_hz = options_.density_to_hz,
         .threads = options_.threads,
         .proceed = [this] { return session_.proceeds(); },
         .on_progress = [this](double share, const std::string& what) { report(share, what); }});
    std::string uncertain;
    for (const DensityPoint& point : result_.density)
      if (!point.certain) uncertain += fmt::format("{}{:.6g}", uncertain.empty() ? "" : ", ", point.to_hz);
    if (!uncertain.empty())
      session_.warn(
          response::uncertain_warning(fmt::format("the counts below {} Hz in density.csv", uncertain)));
  }

  const scenario::Plan& plan_;
  const VibrationOptions& options_;
  run::Session& session_;
  const run::RunDirectory& directory_;
  std::unique_ptr<Simulation> simulation_;  // at the end of the stages, or its equilibrium nearby
  response::AssemblyOptions assembly_;
  std::optional<response::LinearSystem> system_;
  Vibration result_;
  double done_ = 0, part_ = 0;  // in factorisations
};

}  // namespace

Vibration vibrate(const scenario::Plan& plan, const VibrationOptions& options) {
  run::Session session(run::modes_results, plan, run::session_options(options));
  VibrationStudy study(plan, options, session);
  session.begin(study);
  return study.result();
}

}  // namespace scree::modes
