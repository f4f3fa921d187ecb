#include "studies/state_fields.hpp"

#include "support/last_state.hpp"
#include "support/output_file.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/fields/field_files.hpp>
#include <scree/fields/field_sums.hpp>
#include <scree/fields/frame_input.hpp>
#include <scree/fields/step_balance.hpp>
#include <scree/files/text_file.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/run/evaluated_state.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

bool is_image(const fs::path& out) { return out.extension() == ".vti"; }

fs::path numbered(const fs::path& out, std::size_t number) {
  return out.parent_path() / fmt::format("{}_{:04}.vti", out.stem().string(), number);
}

// The files that will be written.
std::vector<fs::path> files_of(const FieldsOptions& options) {
  const bool many = !options.average && options.sources.size() > 1;
  if (!is_image(options.out) || !many) return {options.out};
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < options.sources.size(); ++k) files.push_back(numbered(options.out, k + 1));
  files.push_back(fs::path(options.out).replace_extension(".pvd"));
  return files;
}

void check_files(const FieldsOptions& options) {
  if (options.out.extension() != ".csv" && !is_image(options.out))
    throw Error(options.out.string(), "is neither .csv nor .vti", "give another --out");
  for (const fs::path& file : files_of(options)) check_output_file("--out", file, options.overwrite);
}

bool is_frame(const fs::path& source) { return source.extension() == ".vtp"; }

// States have masses of their own.
void check_masses(const FieldsOptions& options) {
  if (std::any_of(options.sources.begin(), options.sources.end(), is_frame)) return;
  const char* const needless = options.density_of_frames ? "--density"
                               : options.state_of_frames ? "--state"
                                                         : nullptr;
  if (needless)
    throw Error(needless, "is for frames (.vtp), but " + options.sources.front().string() + " has masses",
                "leave it out");
}

// The fields of the states that it is given, one after another, and their balances.
class StateFields {
 public:
  StateFields(const FieldsOptions& options, PluginHost& host)
      : options_(options), host_(host), threads_(options.threads, ThreadPool::IfTooFew::use_fewer) {}

  void add(const fs::path& file) {
    fields::FieldInput input = is_frame(file) ? frame_in(file) : state_in(file);
    if (!kernel_) choose_grid(input);
    try {
      add_to_sums(input);
      // Frames do not say how often bodies crossed a periodic face.
      if (last_ && simulation_)
        mass_ =
            std::max(mass_.value_or(0), mass_balance(*last_, input, grid_, *kernel_, threads_).relative());
    } catch (const Error& error) {
      throw error.at(file.string());
    }
    last_ = std::move(input);
  }

  void write() {
    if (options_.average) finish_frame();
    const std::vector<fs::path> files = files_of(options_);
    if (!is_image(options_.out)) {
      files::write_atomically(options_.out, fields::format_csv(grid_, frames_, comments()));
    } else {
      std::vector<fields::TimedFile> timed;
      for (std::size_t k = 0; k < frames_.size(); ++k) {
        files::write_atomically(files[k], fields::format_vti(grid_, frames_[k]));
        timed.push_back({frames_[k].time, files[k].filename().string()});
      }
      if (frames_.size() > 1) files::write_atomically(files.back(), fields::format_pvd(timed));
    }
    fmt::print("{}: {}, {}{}, width {:g} m, spacing {:g} m\n", files.back().string(),
               counted(grid_.size(), "point"),
               counted(options_.sources.size(), frame_count_ > 0 ? "frame" : "state"),
               options_.average ? " averaged" : "", kernel_->width(), grid_.spacing[0]);
  }

  // What the balances leave open, over the largest term.
  void print_balances() {
    fmt::print("forces, net + div stress - traction - body forces - loads: {:.1e} of the largest term\n",
               forces_);
    if (mass_) fmt::print("mass from state to state: {:.1e}\n", *mass_);
    if (!simulation_) return;
    const fields::StepBalances step = balances_over_step(*simulation_, *last_, grid_, *kernel_, threads_);
    const std::string after = step.steps > 1 ? fmt::format(" {} steps after", step.steps - 1) : " from";
    fmt::print("mass over a step of {:g} s{} the last state: {:.1e}\n", step.length, after,
               step.mass.relative());
    fmt::print("momentum over that step: {:.1e}\n", step.momentum.relative());
  }

 private:
  fields::FieldInput state_in(const fs::path& file) {
    run::EvaluatedSimulation state = run::evaluated_simulation(state_file::read_state(file), file, host_);
    simulation_ = std::move(state.simulation);
    if (!fields::forces_are_present(*simulation_)) {
      state.has_forces = false;
      simulation_->apply_reconfiguration();
    }
    evaluated_ += !state.has_forces;
    return fields::input_of(*simulation_);
  }
  fields::FieldInput frame_in(const fs::path& file) {
    simulation_.reset();
    ++frame_count_;
    const pictures::Frame frame = pictures::load_backend()->read_frame(file);
    if (!facts_) facts_ = facts_of(file);
    try {
      return fields::input_of_frame(frame, *facts_);
    } catch (const Error& error) {
      throw error.at(file.string());
    }
  }
  // Of the first frame; others are of the same run.
  fields::FrameFacts facts_of(const fs::path& file) const {
    if (options_.density_of_frames) return fields::FrameFacts(*options_.density_of_frames);
    const fs::path run = fs::absolute(file).lexically_normal().parent_path().parent_path();
    const auto state = options_.state_of_frames ? options_.state_of_frames : last_state(run);
    if (!state)
      throw Error(file.string(), "has no masses, and its run has no state from which to take them",
                  "give a --state of the run, or the --density of all bodies");
    return fields::FrameFacts(state_file::read_state(*state));
  }
  void choose_grid(const fields::FieldInput& input) {
    const fields::GridRequest request = options_.request(input.dimension);
    try {
      grid_ = grid_for(request, input);
    } catch (const Error& error) {  // names the key, which is an option here
      throw Error("--" + error.place(), error.problem(), error.cure(), error.status());
    }
    kernel_.emplace(kernel_for(request, input));
    sums_.emplace(grid_, *kernel_);
  }
  void add_to_sums(const fields::FieldInput& input) {
    sums_->add(input, threads_);
    if (!options_.average) finish_frame();
  }
  void finish_frame() {
    frames_.push_back({sums_->mean_time(), sums_->means()});
    forces_ = std::max(forces_, force_residual(frames_.back().points));
    sums_.emplace(grid_, *kernel_);
  }
  std::vector<std::string> comments() const {
    std::vector<std::string> lines = {
        fmt::format("dimension: {}", grid_.dimension), fmt::format("width [m]: {}", kernel_->width()),
        fmt::format("kernel: {}", fields::kernel_names[std::size_t(kernel_->shape())]),
        fmt::format("states: {}{}", options_.sources.size(), options_.average ? ", averaged" : "")};
    if (evaluated_ > 0)
      lines.push_back(fmt::format("forces: of {} evaluated from positions, velocities and springs",
                                  counted(evaluated_, "state")));
    if (frame_count_ > 0)
      lines.push_back(
          fmt::format("body_force: of {} all that no contact exerts", counted(frame_count_, "frame")));
    return lines;
  }

  const FieldsOptions& options_;
  PluginHost& host_;
  ThreadPool threads_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<fields::FieldInput> last_;
  fields::FieldGrid grid_;
  std::optional<fields::AveragingKernel> kernel_;
  std::optional<fields::FieldSums> sums_;
  std::vector<fields::FieldFrame> frames_;
  double forces_ = 0;
  std::size_t evaluated_ = 0;  // states whose forces are not those of the run
  std::size_t frame_count_ = 0;
  std::optional<fields::FrameFacts> facts_;
  std::optional<double> mass_;
};

}  // namespace

void write_fields(const FieldsOptions& options, PluginHost& host) {
  check_files(options);
  check_masses(options);
  StateFields all(options, host);
  for (const fs::path& source : options.sources) all.add(source);
  all.write();
  all.print_balances();
}

}  // namespace scree::tool
