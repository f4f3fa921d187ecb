#include "linear.hpp"

#include "displaced_view.hpp"
#include "driven_walls.hpp"
#include "observer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::sound {

namespace {

using Complex = std::complex<double>;

// Largest displacement of a difference over the smallest radius: far above round-off of positions, far below contact sizes.
constexpr double largest_share = 1e-3;
// Change of a derivative with the size of the difference, over its largest value, from which a column is refused.
constexpr double largest_change = 0.05;

class Columns {
 public:
  Columns(const Start& start, Simulation& simulation, const std::vector<Vec3>& walls,
          const HarmonicMotion& motion)
      : start_(start), observer_(start.plan), view_(simulation, walls, motion.freedom) {
    if (observer_.needs() & (SCREE_NEEDS_CONTACTS | SCREE_NEEDS_ENERGY))
      throw Error(fmt::format(
          "{}: a column that reads contacts or energies has no linear response; observe positions, such as a strain, or leave the "
          "road linear out",
          start.spectrum().observed[0].place));
    rest_ = observer_.values(view_.at_rest());
    for (std::size_t i = 0; i < simulation.particles().size(); ++i)
      smallest_ = i == 0 ? simulation.particles().radius()[i]
                         : std::min(smallest_, simulation.particles().radius()[i]);
  }

  const std::vector<double>& at_rest() const { return rest_; }

  // Derivatives along a motion, and how much they change if the difference has half the size.
  std::pair<std::vector<Complex>, std::vector<double>> along(const response::HarmonicResponse& motion) {
    // The wall moves by 1 m.
    const double share = largest_share * smallest_ / std::max(1.0, motion.amplitude.cwiseAbs().maxCoeff());
    const std::vector<Complex> whole = difference(motion, share);
    std::vector<Complex> half = difference(motion, 0.5 * share);
    std::vector<double> change;
    for (std::size_t c = 0; c < whole.size(); ++c) change.push_back(std::abs(whole[c] - half[c]));
    return {whole, std::move(change)};
  }

 private:
  std::vector<Complex> difference(const response::HarmonicResponse& motion, double share) {
    using Part = DisplacedView::Part;
    std::vector<Complex> sum(rest_.size());
    for (const auto& [part, factor] :
         {std::pair{Part::real, Complex(1, 0)}, {Part::imaginary, Complex(0, 1)}})
      for (const double sign : {1.0, -1.0}) {
        const std::vector<double>& values = observer_.values(view_.displaced(motion, part, sign * share));
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += sign / (2 * share) * factor * values[c];
      }
    return sum;
  }

  const Start& start_;
  Observer observer_;
  DisplacedView view_;
  std::vector<double> rest_;
  double smallest_ = 0;  // (m) radius
};

void check_column(const scenario::ObservedColumn& observed, const RoadSpectrum::Column& column,
                  const std::vector<double>& change) {
  double largest = 0;
  for (const Complex& h : column.response) largest = std::max(largest, std::abs(h));
  if (largest == 0)
    throw Error(fmt::format(
        "{}: '{}' does not depend on positions and velocities of bodies, so that it has no linear response; "
        "observe another column, or leave the road linear out",
        observed.place, observed.name));
  const double worst = *std::max_element(change.begin(), change.end());
  if (!(worst <= largest_change * largest))
    throw Error(fmt::format(
        "{}: '{}' is not linear in small displacements (its derivative changes by {:.2g} of its largest value); observe another "
        "column, or leave the road linear out",
        observed.place, observed.name, worst / largest));
}

}  // namespace

RoadSpectrum linear_spectrum(const Start& start) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const scenario::SpectrumPlan& plan = start.spectrum();
  Simulation simulation(start.scene, start.state);
  const DrivenWalls walls(start);
  start.on_progress(0, "linear response");
  const HarmonicMotion motion = harmonic_motion(
      simulation, walls.motion(), plan.frequencies(), {.fewest_contacts = plan.fewest_contacts},
      {.tolerance = plan.tolerance, .threads = start.scene.threads});
  Columns columns(start, simulation, walls.motion(), motion);
  RoadSpectrum road{.road = "linear", .frequencies = plan.frequencies(), .columns = {}, .notes = {}};
  road.columns.resize(plan.observed.size());
  std::vector<std::vector<double>> changes(plan.observed.size());
  for (const response::HarmonicResponse& response : motion.responses) {
    const auto [derivatives, change] = columns.along(response);
    for (std::size_t c = 0; c < derivatives.size(); ++c) {
      const double scale = plan.observed[c].relative ? 1 / std::abs(columns.at_rest()[c]) : 1;
      road.columns[c].response.push_back(scale * derivatives[c]);
      road.columns[c].error.push_back(scale * (change[c] + response.error * std::abs(derivatives[c])));
      changes[c].push_back(scale * change[c]);
    }
  }
  for (std::size_t c = 0; c < responding(plan.observed); ++c)
    check_column(plan.observed[c], road.columns[c], changes[c]);
  road.wall = std::chrono::duration<double>(Clock::now() - began).count();
  return road;
}

}  // namespace scree::sound
