#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// One way to compute a scene.
struct Setting {
  Integration integration = Integration::velocity_verlet;
  Precision precision = Precision::double_precision;
  double step = 0;  // (s)
};
// "velocity_verlet, double".
std::string method_name(const Setting& setting);

// What is compared. The last quantity of a study, "positions", is the root mean square distance of the bodies
// from where the reference has them, in mean radii.
struct Quantity {
  std::string name;
  double reference = 0;
  double uncertainty = 0;    // of the reference: how much its last refinement changed it
  double chosen_scale = 0;   // of [[expect]]; 0: none
  bool closed_form = false;  // the reference is the one that [[expect]] names
  // What errors are divided by: the chosen scale, or |reference|, or 1 where that is 0.
  double scale() const;
};

// How a setting came out.
struct Outcome {
  Setting setting;
  std::string problem;  // why there are no numbers; empty if there are
  double wall = 0;      // (s) of the time loop, the shortest of some
  std::uint64_t steps = 0;
  std::vector<double> values, errors;  // of each quantity; errors are relative
  // The largest error of all quantities, and whose it is.
  double worst() const;
  // Of one quantity, or the worst.
  double error(std::optional<std::size_t> quantity) const { return quantity ? errors[*quantity] : worst(); }
  std::size_t worst_quantity() const;
};

// Slope of log(error) over log(step), fitted where errors fall with the step: neither saturated, nor lost in
// the reference's own uncertainty, in round-off or in what does not depend on the step.
struct Order {
  Setting method;                                // its step is 0
  std::optional<double> of_worst, of_positions;  // absent with fewer than 3 points to fit
};

struct Study {
  double duration = 0;            // (s) of the time that is compared
  std::optional<double> horizon;  // (s) until when the reference is trustworthy, if it ends before the scene
  std::vector<Quantity> quantities;
  std::vector<std::string>
      notes;  // what a reader must know: left-out quantities, ends that depend on the step
  std::vector<Outcome> outcomes;
  std::vector<Order> orders;
  double tolerance = 0;
  bool interrupted = false;
};

struct StudyOptions {
  double coarsest = 4;  // longest step, in steps of the scenario
  int count = 6;        // of steps, each half of the one before; at least 2
  double tolerance = 1e-3;
  std::vector<Integration> integrations;  // all if empty
  std::function<void(double share, const std::string& what)> on_progress;
  const std::atomic<bool>* stop = nullptr;
};

// Runs a plan over steps, integrators and precisions, and compares with a reference: the closed form of
// [[expect]] where it gives one, 0 for residuals, else Richardson's extrapolation of velocity Verlet in
// double with steps of 1/2, 1/4 and 1/8 of the finest. Steps divide the durations of the stages. Where runs
// with finer and finer steps part ways, as chaotic scenes do, all are cut at the time until which they
// agree to a tenth of the tolerance (or 1e-5 if that is more) in mean radii, and compared there. Throws Error
// where the scenario itself cannot run.
Study study(const scenario::Plan& plan, const StudyOptions& options);

// The cheapest outcome whose worst error is within the tolerance; null if none is.
const Outcome* cheapest(const Study& study);
// Outcomes that no other beats in both wall time and the error of a quantity, or the worst, by wall time;
// gains under 5 % of the error are timing noise and do not count.
std::vector<const Outcome*> pareto_front(const Study& study,
                                         std::optional<std::size_t> quantity = std::nullopt);

}  // namespace scree::accuracy
