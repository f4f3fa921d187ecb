#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// One setting of integrator and time step.
struct Setting {
  Integration integration = Integration::velocity_verlet;
  double step = 0;  // (s)
};

// A compared quantity. The last one of a study of a run, "positions", is the root mean square distance of the
// bodies from their positions in the reference, in mean radii.
struct Quantity {
  std::string name;
  double reference = 0;
  double uncertainty = 0;    // of the reference: its change by the last refinement
  double chosen_scale = 0;   // `scale` of [[expect]]; 0: none
  bool closed_form = false;  // the reference is that of [[expect]]
  // Divisor of errors: the chosen scale, else |reference|, else 1.
  double scale() const;
};

// Result of a setting.
struct SettingResult {
  Setting setting;
  std::string problem;   // why there are no results; empty if there are
  double wall_time = 0;  // (s) of the time loop, and of the methods to a peak; minimum over repeats
  std::uint64_t steps = 0;
  std::vector<double> values, errors;  // of each quantity; errors are relative
  // The largest error of all quantities.
  double worst() const;
  // Error of one quantity, or the largest error.
  double error(std::optional<std::size_t> quantity) const { return quantity ? errors[*quantity] : worst(); }
  std::size_t worst_quantity() const;
};

// Slope of log(error) over log(step), fitted where errors decrease with the step: not saturated, and above
// the uncertainty of the reference, round-off and errors that do not depend on the step.
struct Order {
  Integration integration = Integration::velocity_verlet;
  std::optional<double> of_worst;  // absent with fewer than 3 points to fit
  std::vector<std::optional<double>> of_quantities;
};

// The longest step (s) with which an error stays within the tolerance, between two tried ones from their
// errors; no longer than the longest tried one, and absent if the error of the shortest is larger.
struct LongestStep {
  Integration integration = Integration::velocity_verlet;
  std::optional<double> of_worst;  // for all quantities
  std::vector<std::optional<double>> of_quantities;
};

// What a study has found.
struct Convergence {
  double duration = 0;  // (s) simulated time of the comparison
  std::optional<double>
      horizon;  // (s) until which the reference is trustworthy; absent: to the end of the scene
  std::vector<Quantity> quantities;
  std::vector<std::string> notes;  // remarks: excluded quantities, ends of stages that depend on the step
  std::vector<SettingResult> outcomes;
  std::vector<Order> orders;
  std::vector<LongestStep> longest_steps;
  bool of_peaks = false;
  double tolerance = 0;
  bool interrupted = false;
};

struct StudyOptions {
  double coarsest = 4;  // longest step, in units of the step of the scenario
  int count = 6;        // number of steps, each half of the previous; at least 2
  double tolerance = 1e-3;
  std::vector<Integration> integrations;  // all if empty
  // Compared ones; those of [[expect]] if empty. A peak, "peaks.pulse.strain.strain.peak_2", stands for its
  // frequency and quality.
  std::vector<std::string> quantities;
  std::function<void(double share, const std::string& what)> on_progress;
  const std::atomic<bool>* stop = nullptr;
};

// The same with a directory.
struct RecordedStudyOptions : StudyOptions {
  std::filesystem::path out;  // empty: runs/<stem of the scenario>-accuracy, numbered if it exists
  bool overwrite = false;
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  std::function<void(const Convergence&)> on_result;   // called before the tables are written
};

// Runs a plan with all steps and integrators, and compares with a reference: the closed form of
// [[expect]] if there is one, 0 for residuals, else the Richardson extrapolation of velocity Verlet
// with 1/2, 1/4 and 1/8 of the finest step. Steps divide the durations of the stages. If runs
// diverge under refinement, as in chaotic scenes, all are compared at the time until which they agree to a
// tenth of the tolerance (at least 1e-5) in mean radii. Quantities of peaks are compared if `quantities`
// names some, or if the plan has no stages or no [[expect]] of a run; then each setting measures these peaks
// by their methods. Throws Error if the scenario cannot run, or if quantities are unknown or of both kinds.
Convergence study(const scenario::Plan& plan, const StudyOptions& options);

// The same, and writes accuracy.csv, accuracy.json and charts/ (see report.hpp). Nothing is written before
// the reference is complete. Returns the directory too.
std::pair<Convergence, std::filesystem::path> recorded_study(const scenario::Plan& plan,
                                                             const RecordedStudyOptions& options);

// The cheapest outcome whose worst error is within the tolerance; null if none is.
const SettingResult* cheapest(const Convergence& study);
// Pareto-optimal outcomes in wall time and the error of a quantity (or the largest error), sorted by wall
// time; a slower outcome must reduce the error by more than 5 %, as less is timing noise.
std::vector<const SettingResult*> pareto_front(const Convergence& study,
                                               std::optional<std::size_t> quantity = std::nullopt);

}  // namespace scree::accuracy
