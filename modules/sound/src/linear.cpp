#include "linear.hpp"

#include "displaced_view.hpp"
#include "driven_walls.hpp"
#include "linear_grid.hpp"
#include "observer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::sound {

namespace {

using Complex = std::complex<double>;

// Times that narrow maxima get more frequencies.
constexpr int most_refinements = 4;
// Largest displacement of a difference over the smallest radius: far above round-off of positions, far below contact sizes.
constexpr double largest_share = 1e-3;
// Change of a derivative with the size of the difference, over its largest value, from which a column is refused.
constexpr double largest_change = 0.05;

class Columns {
 public:
  Columns(const Start& start, Simulation& simulation, const std::vector<Vec3>& walls,
          const HarmonicMotion& motion)
      : observer_(start.plan), view_(simulation, walls, motion.freedom) {
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

  Observer observer_;
  DisplacedView view_;
  std::vector<double> rest_;
  double smallest_ = 0;  // (m) radius
};

// Before the solution, which takes longer.
void check_needs(const Start& start) {
  if (Observer(start.plan).needs() & (SCREE_NEEDS_CONTACTS | SCREE_NEEDS_ENERGY))
    throw Error(fmt::format(
        "{}: a column that reads contacts or energies has no linear response; observe positions, such as a strain, or leave the "
        "road linear out",
        start.spectrum().observed[0].place));
}

void check_column(const scenario::ObservedColumn& observed, const RoadSpectrum::Column& column) {
  double largest = 0;
  for (const Complex& h : column.response) largest = std::max(largest, std::abs(h));
  if (largest == 0)
    throw Error(fmt::format(
        "{}: '{}' does not depend on positions and velocities of bodies, so that it has no linear response; "
        "observe another column, or leave the road linear out",
        observed.place, observed.name));
  const double worst = *std::max_element(column.linearity.begin(), column.linearity.end());
  if (!(worst <= largest_change * largest))
    throw Error(fmt::format(
        "{}: '{}' is not linear in small displacements (its derivative changes by {:.2g} of its largest value); observe another "
        "column, or leave the road linear out",
        observed.place, observed.name, worst / largest));
}

// The frequencies of the plan that a road lacks.
std::vector<double> missing(const std::vector<double>& all, const std::vector<double>& found) {
  std::vector<double> left;
  std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(left));
  return left;
}

// Inserts what the columns do at one frequency.
void insert(const response::HarmonicResponse& response, Columns& columns, const scenario::SpectrumPlan& plan,
            RoadSpectrum& road) {
  const auto [derivatives, change] = columns.along(response);
  const auto at = std::lower_bound(road.frequencies.begin(), road.frequencies.end(), response.frequency_hz) -
                  road.frequencies.begin();
  road.frequencies.insert(road.frequencies.begin() + at, response.frequency_hz);
  for (std::size_t c = 0; c < derivatives.size(); ++c) {
    const double scale = plan.observed[c].relative ? 1 / std::abs(columns.at_rest()[c]) : 1;
    RoadSpectrum::Column& column = road.columns[c];
    const double error = scale * (change[c] + response.error * std::abs(derivatives[c]));
    column.response.insert(column.response.begin() + at, scale * derivatives[c]);
    column.error.insert(column.error.begin() + at, error);
    column.linearity.insert(column.linearity.begin() + at, scale * change[c]);
  }
}

// The frequency with the largest error, if that is above the tolerance.
void note_uncertain(const std::vector<response::HarmonicResponse>& responses, double tolerance,
                    RoadSpectrum& road) {
  const auto worst = std::max_element(responses.begin(), responses.end(),
                                      [](const auto& a, const auto& b) { return a.error < b.error; });
  if (worst == responses.end() || worst->error <= tolerance) return;
  road.notes.push_back(fmt::format(
      "linear: at {:g} Hz the solution has an error of about {:.2g} of itself, above tolerance = {:g}, since a mode without "
      "damping is near, or bodies with too few contacts move freely; add damping, or give a larger fewest_contacts",
      worst->frequency_hz, worst->error, tolerance));
}

void note_sliding(const HarmonicMotion& motion, const scenario::SpectrumPlan& plan, RoadSpectrum& road) {
  if (motion.sliding_contacts == 0 || !road.frequencies.empty()) return;
  road.notes.push_back(fmt::format(
      "linear: {} contacts are at the limit of friction; they {}", motion.sliding_contacts,
      plan.contacts_slide
          ? "slide on, one way, which small oscillations do not; sliding_contacts = \"stick\" holds them"
          : "are taken to stick, as small oscillations make them within some periods; "
            "sliding_contacts = \"slide\" lets them slide on"));
}

// The road at some of its frequencies.
RoadSpectrum part_of(const RoadSpectrum& road, const std::vector<double>& frequencies) {
  RoadSpectrum part{.road = road.road, .frequencies = frequencies, .columns = {}, .notes = {}};
  part.columns.resize(road.columns.size());
  for (const double f : frequencies) {
    const auto at =
        std::lower_bound(road.frequencies.begin(), road.frequencies.end(), f) - road.frequencies.begin();
    for (std::size_t c = 0; c < road.columns.size(); ++c)
      part.columns[c].response.push_back(road.columns[c].response[std::size_t(at)]);
  }
  return part;
}

// Adds those of `wanted` that the road lacks. Returns false after a stop.
bool add_frequencies(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                     const std::vector<double>& wanted, RoadSpectrum& road) {
  const scenario::SpectrumPlan& plan = start.spectrum();
  const std::vector<double> left = missing(wanted, road.frequencies);
  const double all = double(wanted.size()), found = all - double(left.size());
  const auto on_progress = [&](double share) {
    start.on_progress((found + share * double(left.size())) / all, "linear response");
  };
  on_progress(0);
  const HarmonicMotion motion =
      harmonic_motion(simulation, walls.motion(), left,
                      {.fewest_contacts = plan.fewest_contacts,
                       .at_limit = plan.contacts_slide ? response::AtLimit::slide : response::AtLimit::stick},
                      {.tolerance = plan.tolerance,
                       .threads = start.scene.threads,
                       .on_progress = on_progress,
                       .stop = start.stop});
  Columns columns(start, simulation, walls.motion(), motion);
  note_sliding(motion, plan, road);
  for (const response::HarmonicResponse& response : motion.responses) insert(response, columns, plan, road);
  note_uncertain(motion.responses, plan.tolerance, road);
  return motion.responses.size() == left.size();
}

// Narrow maxima get more frequencies from what is known at those before, so that a road that was stopped goes on with the same.
bool add_all_frequencies(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                         RoadSpectrum& road) {
  std::vector<double> wanted = start.spectrum().frequencies();
  for (int refinement = 0;; ++refinement) {
    if (!add_frequencies(start, simulation, walls, wanted, road)) return false;
    if (!start.spectrum().adaptive || refinement == most_refinements) return true;
    const std::vector<double> further = frequencies_about_maxima(start.spectrum(), part_of(road, wanted));
    if (further.empty()) return true;
    std::vector<double> more;
    std::set_union(wanted.begin(), wanted.end(), further.begin(), further.end(), std::back_inserter(more));
    wanted = std::move(more);
  }
}

}  // namespace

bool add_linear(const Start& start, RoadSpectrum& road) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const scenario::SpectrumPlan& plan = start.spectrum();
  check_needs(start);
  Simulation simulation(start.scene, start.state);
  const DrivenWalls walls(start);
  road.road = "linear";
  road.columns.resize(plan.observed.size());
  const bool complete = add_all_frequencies(start, simulation, walls, road);
  road.wall += std::chrono::duration<double>(Clock::now() - began).count();
  if (!complete) return false;
  for (std::size_t c = 0; c < road.columns.size(); ++c) {
    if (!plan.observed[c].of_shape) check_column(plan.observed[c], road.columns[c]);
    road.columns[c].linearity.clear();
  }
  return true;
}

RoadSpectrum linear_spectrum(const Start& start) {
  RoadSpectrum road;
  if (!add_linear(start, road))
    throw Error("interrupted while the linear response was solved", ExitStatus::interrupted);
  return road;
}

}  // namespace scree::sound
