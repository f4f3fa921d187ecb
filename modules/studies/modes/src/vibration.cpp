#include "mode_picture.hpp"
#include "mode_properties.hpp"
#include "mode_warnings.hpp"
#include "search_checks.hpp"
#include "vibration_files.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/try_each.hpp>
#include <scree/modes/vibration.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/response/rest.hpp>
#include <scree/run/run_stages.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/spare_room.hpp>

namespace scree::modes {

namespace {

using run::RunDirectory;

// Seconds of each part over those of a factorisation, for the time left.
constexpr double cost_of_modes = 12, cost_of_a_mode = 0.6, cost_of_constants = 8;

class Course {
 public:
  Course(const scenario::Plan& plan, const VibrationOptions& options, RunDirectory& directory)
      : plan_(plan), options_(options), directory_(directory) {
    assembly_.fewest_contacts = options.fewest_contacts;
    assembly_.at_limit = options.contacts_slide || (plan.spectrum && plan.spectrum->contacts_slide)
                             ? response::AtLimit::slide
                             : response::AtLimit::stick;
    if (options.fewest_contacts == 0 && plan.spectrum)
      assembly_.fewest_contacts = plan.spectrum->fewest_contacts;
    result_.title = plan.heading();
    result_.directory = directory.path();
    result_.dimension = plan.scene.dimension;
    result_.scenario = plan.resolved_text;
    result_.inputs = run::hashes_of(plan.files);
  }

  Vibration begin() {
    auto simulation = run::set_up(plan_, options_.threads);
    check_plan(*simulation);
    for (const std::string& line : simulation->let_go()) warn(line);
    StageRunner stages(*simulation, plan_.stages);
    if (!run::run_stages(
            stages, [this] { return proceeds(); },
            [this](double share, const std::string& stage) { report(share, stage); }))
      throw Error(
          fmt::format(
              "{}: interrupted before the stages had ended; nothing was written, give the same call again",
              plan_.source.string()),
          ExitStatus::interrupted);
    began_ = Clock::now();
    check(simulation);
    describe(*simulation);
    directory_.begin([this] {
      write_record("running", result_, directory_);
      room_.reserve(directory_, record_name);
      directory_.write_file("scenario.toml", plan_.text_for_any_folder);
    });
    try {
      take_parts(*simulation);
      return finish();
    } catch (const Error& error) {
      if (error.status() == ExitStatus::bad_input && result_.modes.empty()) {
        directory_.discard();
        throw;
      }
      save_failed(error.what());
      files::rethrow_as_failure(error);
    } catch (const std::exception& error) {  // such as of memory
      save_failed(error.what());
      throw;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool proceeds() const { return !options_.stop || !*options_.stop; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  // What cannot be done with this plan is refused before a step is taken.
  void check_plan(const Simulation& simulation) const {
    if (!options_.pictures.empty() && !pictures::has_pictures())
      throw Error(
          fmt::format("{}; {}, or leave --picture out", pictures::no_pictures, pictures::no_pictures_cure));
    try {
      check_density(options_);
      response::check_laws(plan_.scene, response::LawsNeeded::any);
      if (options_.elastic) response::wall_pair(simulation);
      const auto last = options_.loads ? run::set_up_with_last_stage(plan_) : nullptr;
      if (last) response::check_loaded_walls(*last);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()), error.status());
    }
  }

  // What cannot be done with this packing is refused before anything is written. The equilibrium nearby takes the place of a packing that
  // is not at rest.
  void check(std::unique_ptr<Simulation>& simulation) {
    try {
      response::Rest rest = response::rest_of(*simulation, assembly_, [this] { return proceeds(); });
      if (rest.equilibrium) simulation = std::move(rest.equilibrium);
      if (!rest.warning.empty()) warn(rest.warning);
      system_.emplace(response::assemble(*simulation, assembly_));
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()), error.status());
    }
  }

  void describe(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) result_.names.push_back(p.id[i]);
    result_.walls = simulation.plane_names();
    for (const std::uint32_t i : system_->rattlers) result_.rattlers.push_back(result_.names[i]);
    result_.bodies = p.size() - system_->rattlers.size();
    result_.contacts = simulation.contact_list().size();
    result_.degrees_of_freedom = std::size_t(system_->freedom.size());
    if (system_->one_way_contacts > 0) warn(response::one_way_warning(system_->one_way_contacts));
  }

  // Share of all parts.
  void report(double share, const std::string& what) {
    if (!options_.on_progress) return;
    const double all = cost_of_modes + cost_of_a_mode * options_.modes +
                       (options_.elastic ? cost_of_constants : 0) + (options_.loads ? cost_of_constants : 0) +
                       options_.density;
    options_.on_progress(std::min(1.0, (done_ + share * part_) / all), seconds(), what);
  }

  template <class Work>
  void take(const char* name, double cost, const Work& work) {
    if (!proceeds()) return;
    part_ = cost;
    const double start = seconds();
    work();
    result_.seconds.emplace_back(name, seconds() - start);
    write_tables(result_, directory_);
    done_ += cost;
  }

  void take_parts(const Simulation& simulation) {
    const response::UndampedSystem undamped(*system_);
    result_.asymmetry = undamped.asymmetry();
    try {
      check_search(undamped, options_);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()));
    }
    take("modes", cost_of_modes + cost_of_a_mode * options_.modes, [&] { take_modes(undamped, simulation); });
    if (options_.elastic) take("elastic", cost_of_constants, [&] { take_constants(simulation); });
    if (options_.loads) take("loads", cost_of_constants, [&] { take_loads(simulation); });
    if (options_.density > 0) take("density", options_.density, [&] { take_density(undamped); });
  }

  void take_modes(const response::UndampedSystem& undamped, const Simulation& simulation) {
    const response::FoundModes found = find_modes(
        undamped, {.count = options_.modes,
                   .near_hz = options_.near_hz,
                   .proceed = [this] { return proceeds(); },
                   .on_progress = [this](double share, const std::string& what) { report(share, what); }});
    result_.unstable = found.unstable, result_.floppy = found.floppy;
    result_.counted = found.counted, result_.complete = found.complete;
    result_.modes = properties_of(found, *system_);
    result_.floppy_bodies = floppy_bodies(found, *system_);
    if (proceeds())
      for (const std::string& warning :
           mode_warnings(result_, found.of_full_stiffness, options_.residual_limit))
        warn(warning);
    if (!found.certain) warn(response::uncertain_warning("the numbers of unstable, floppy and found modes"));
    for (const unsigned number : options_.pictures) draw(simulation, found, number);
  }

  void draw(const Simulation& simulation, const response::FoundModes& found, unsigned number) {
    const std::size_t m = found.first_vibrating + number - 1;
    if (m >= result_.modes.size()) {
      if (proceeds())
        warn(fmt::format("there is no mode {}, of which a picture was asked for; ask for more --modes",
                         number));
      return;
    }
    const std::string name = fmt::format("images/mode_{}.png", number);
    try_to_draw(name, [&] {
      draw_mode(simulation, system_->freedom, found.shape.col(Eigen::Index(m)),
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
      warn(fmt::format("{} was not drawn: {}", name, error.what()));
    }
  }

  void take_constants(const Simulation& simulation) {
    report(0, "elastic constants");
    try {
      result_.elastic = response::elastic_moduli(simulation, assembly_, [this] { return proceeds(); });
    } catch (const Error& error) {
      if (error.status() == ExitStatus::interrupted) return;
      warn(error.what());
    }
  }

  void take_loads(const Simulation& simulation) {
    report(0, "loads on walls");
    try {
      result_.loads = response::load_responses(simulation, assembly_, [this] { return proceeds(); });
    } catch (const Error& error) {
      if (error.status() == ExitStatus::interrupted) return;
      warn(error.what());
    }
    for (const response::LoadResponse& load : result_.loads)
      if (!(load.residual <= response::LoadResponse::largest_residual))
        warn(fmt::format(
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
         .proceed = [this] { return proceeds(); },
         .on_progress = [this](double share, const std::string& what) { report(share, what); }});
    std::string uncertain;
    for (const DensityPoint& point : result_.density)
      if (!point.certain) uncertain += fmt::format("{}{:.6g}", uncertain.empty() ? "" : ", ", point.to_hz);
    if (!uncertain.empty())
      warn(response::uncertain_warning(fmt::format("the counts below {} Hz in density.csv", uncertain)));
  }

  void warn(const std::string& line) {
    result_.warnings.push_back(line);
    if (options_.on_warning) options_.on_warning(line);
  }

  void save_failed(const std::string& failure) {
    result_.error = failure;
    room_.release();
    files::try_each([&] { write_record("failed", result_, directory_); },
                    [&] { write_tables(result_, directory_); });
  }

  Vibration finish() {
    result_.interrupted = !proceeds();
    write_tables(result_, directory_);
    try_to_draw("charts", [&] { draw_charts(result_, directory_); });
    room_.release();
    write_record(result_.interrupted ? "interrupted" : "finished", result_, directory_);
    return std::move(result_);
  }

  const scenario::Plan& plan_;
  const VibrationOptions& options_;
  RunDirectory& directory_;
  response::AssemblyOptions assembly_;
  std::optional<response::LinearSystem> system_;
  Vibration result_;
  run::SpareRoom room_;
  double done_ = 0, part_ = 0;  // in factorisations
  Clock::time_point began_ = Clock::now();
};

}  // namespace

Vibration vibrate(const scenario::Plan& plan, const VibrationOptions& options) {
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                                    RunDirectory::Kind::response);
  directory.report_lock(options.on_warning);
  return Course(plan, options, directory).begin();
}

}  // namespace scree::modes
