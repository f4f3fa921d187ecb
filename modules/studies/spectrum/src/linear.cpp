#include "linear.hpp"

#include "driven_walls.hpp"
#include "harmonic_motion.hpp"
#include "linear_columns.hpp"
#include "linear_frequencies.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/response/rest.hpp>

namespace scree::spectrum {

namespace {

using Complex = std::complex<double>;

// Times that narrow maxima get more frequencies.
constexpr int most_refinements = 4;
// Change of a derivative at half the difference, over its largest value, above which a column is refused.
constexpr double largest_change = 0.05;

void check_column(const ObservedColumn& observed, const MethodSpectrum::Column& column,
                  const std::function<std::string()>& cure) {
  double largest = 0;
  for (const Complex& h : column.response) largest = std::max(largest, std::abs(h));
  if (largest == 0)
    throw Error(fmt::format(
        "{}: '{}' does not respond: small displacements and velocities of bodies and walls leave it "
        "as it is, and forces, torques and spins of bodies are not followed; {}, or leave the method linear out",
        observed.place, observed.name, cure()));
  const double worst = *std::max_element(column.linearity.begin(), column.linearity.end());
  if (!(worst <= largest_change * largest))
    throw Error(fmt::format(
        "{}: '{}' is not linear in small displacements (its derivative changes by {:.2g} of its largest value); observe another "
        "column, or leave the method linear out",
        observed.place, observed.name, worst / largest));
}

// Inserts what the columns do at one frequency.
void insert(const response::HarmonicResponse& response, LinearColumns& columns, const SpectrumPlan& plan,
            MethodSpectrum& spectrum) {
  const auto [derivatives, change] = columns.along(response);
  const auto at =
      std::lower_bound(spectrum.frequencies.begin(), spectrum.frequencies.end(), response.frequency_hz) -
      spectrum.frequencies.begin();
  spectrum.frequencies.insert(spectrum.frequencies.begin() + at, response.frequency_hz);
  for (std::size_t c = 0; c < derivatives.size(); ++c) {
    const double scale = plan.observed[c].relative ? 1 / std::abs(columns.at_rest()[c]) : 1;
    MethodSpectrum::Column& column = spectrum.columns[c];
    const double error = scale * (change[c] + response.error * std::abs(derivatives[c]));
    column.response.insert(column.response.begin() + at, scale * derivatives[c]);
    column.error.insert(column.error.begin() + at, error);
    column.linearity.insert(column.linearity.begin() + at, scale * change[c]);
  }
}

// The frequency with the largest error, if that is above the tolerance.
void note_uncertain(const std::vector<response::HarmonicResponse>& responses, double tolerance,
                    MethodSpectrum& spectrum) {
  const auto worst = std::max_element(responses.begin(), responses.end(),
                                      [](const auto& a, const auto& b) { return a.error < b.error; });
  if (worst == responses.end() || worst->error <= tolerance) return;
  spectrum.notes.push_back(fmt::format(
      "linear: at {:g} Hz the solution has an error of about {:.2g} of itself, above spectrum.linear.tolerance = {:g}, since a mode without "
      "damping is near, or bodies with too few contacts move freely; add damping, or give a larger linear.fewest_contacts",
      worst->frequency_hz, worst->error, tolerance));
}

void note_sliding(const HarmonicMotion& motion, const SpectrumPlan& plan, MethodSpectrum& spectrum) {
  if (motion.sliding_contacts == 0 || !spectrum.frequencies.empty()) return;
  spectrum.notes.push_back(fmt::format(
      "linear: {} at the limit of friction; they {}",
      counted(motion.sliding_contacts, "contact is", "contacts are"),
      plan.linear.contacts_slide
          ? "slide on, one way, which small oscillations do not; linear.sliding_contacts = \"stick\" holds them"
          : "are taken to stick, as small oscillations make them within some periods; "
            "linear.sliding_contacts = \"slide\" lets them slide on"));
}

void note_one_way(const HarmonicMotion& motion, MethodSpectrum& spectrum) {
  if (motion.one_way_contacts == 0 || !spectrum.frequencies.empty()) return;
  spectrum.notes.push_back("linear: " + response::one_way_warning(motion.one_way_contacts));
}

response::AssemblyOptions assembly_of(const SpectrumPlan& plan) {
  return {.fewest_contacts = plan.linear.fewest_contacts,
          .at_limit = plan.linear.contacts_slide ? response::AtLimit::slide : response::AtLimit::stick,
          .time_step = plan.linear.step_of_run ? response::TimeStep::of_run : response::TimeStep::limit};
}

// The spectrum at some of its frequencies.
MethodSpectrum part_of(const MethodSpectrum& spectrum, const std::vector<double>& frequencies) {
  MethodSpectrum part{.method = spectrum.method, .frequencies = frequencies, .columns = {}, .notes = {}};
  part.columns.resize(spectrum.columns.size());
  for (const double f : frequencies) {
    const auto at = std::lower_bound(spectrum.frequencies.begin(), spectrum.frequencies.end(), f) -
                    spectrum.frequencies.begin();
    for (std::size_t c = 0; c < spectrum.columns.size(); ++c)
      part.columns[c].response.push_back(spectrum.columns[c].response[std::size_t(at)]);
  }
  return part;
}

// Adds a batch of frequencies. Returns false after a stop.
bool add_batch(const Start& start, Simulation& simulation, const DrivenWalls& walls,
               const std::vector<double>& batch, const std::function<void(double)>& on_progress,
               MethodSpectrum& spectrum) {
  const SpectrumPlan& plan = start.spectrum;
  const HarmonicMotion motion = harmonic_motion(simulation, walls.motion(), batch, assembly_of(plan),
                                                {.tolerance = plan.linear.tolerance,
                                                 .threads = start.scene.threads,
                                                 .on_progress = on_progress,
                                                 .stop = start.stop});
  LinearColumns columns(start.plan, plan.observed, simulation, walls.motion(), motion.freedom,
                        motion.time_step);
  note_sliding(motion, plan, spectrum);
  note_one_way(motion, spectrum);
  for (const response::HarmonicResponse& response : motion.responses)
    insert(response, columns, plan, spectrum);
  note_uncertain(motion.responses, plan.linear.tolerance, spectrum);
  return motion.responses.size() == batch.size();
}

// Adds the frequencies of `wanted` that the spectrum lacks. Returns false after a stop.
bool add_frequencies(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                     const std::vector<double>& wanted, const std::function<void()>& on_part,
                     MethodSpectrum& spectrum) {
  while (true) {
    const std::vector<double> left = missing(wanted, spectrum.frequencies),
                              batch = first_batch(left, simulation.particles().size());
    const double all = double(wanted.size()), found = all - double(left.size());
    const auto on_progress = [&](double share) {
      start.on_progress((found + share * double(batch.size())) / all, "linear response");
    };
    on_progress(0);
    if (!add_batch(start, simulation, walls, batch, on_progress, spectrum)) return false;
    on_part();
    if (batch.size() == left.size()) return true;
  }
}

// Narrow maxima get more frequencies, from what is known at the frequencies before, so that a solution that
// was stopped continues with the same.
bool add_all_frequencies(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                         const std::function<void()>& on_part, MethodSpectrum& spectrum) {
  std::vector<double> wanted = start.spectrum.frequencies();
  for (int refinement = 0;; ++refinement) {
    if (!add_frequencies(start, simulation, walls, wanted, on_part, spectrum)) return false;
    if (!start.spectrum.linear.adaptive || refinement == most_refinements) return true;
    const std::vector<double> further = frequencies_about_maxima(start.spectrum, part_of(spectrum, wanted));
    if (further.empty()) return true;
    std::vector<double> more;
    std::set_union(wanted.begin(), wanted.end(), further.begin(), further.end(), std::back_inserter(more));
    wanted = std::move(more);
  }
}

// What to observe instead of a column that does not respond.
std::string observe_cure(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                         double frequency_hz) {
  const HarmonicMotion motion =
      harmonic_motion(simulation, walls.motion(), {frequency_hz}, assembly_of(start.spectrum),
                      {.tolerance = start.spectrum.linear.tolerance, .stop = start.stop});
  if (motion.responses.empty()) return "observe another column";
  constexpr std::size_t most_named = 8;
  std::vector<std::string> names =
      responding_columns(start.plan, simulation, walls.motion(), motion.freedom, motion.responses[0]);
  if (names.empty()) return "observe another column";
  const std::size_t others = names.size() - std::min(names.size(), most_named);
  names.resize(names.size() - others);
  return fmt::format("observe one that does: {}{}", fmt::join(names, ", "),
                     others ? fmt::format(" and {} more", others) : "");
}

void check_columns(const Start& start, Simulation& simulation, const DrivenWalls& walls,
                   const MethodSpectrum& spectrum) {
  const std::vector<ObservedColumn>& observed = start.spectrum.observed;
  for (std::size_t c = 0; c < responding(observed); ++c)
    check_column(observed[c], spectrum.columns[c],
                 [&] { return observe_cure(start, simulation, walls, spectrum.frequencies.back()); });
}

}  // namespace

void check_response(const Start& start) {
  Simulation simulation(start.scene, start.state);
  const DrivenWalls walls(start);
  MethodSpectrum spectrum;
  const double lowest = start.spectrum.from_hz;
  spectrum.columns.resize(start.spectrum.observed.size());
  if (add_batch(
          start, simulation, walls, {lowest}, [](double) {}, spectrum))
    check_columns(start, simulation, walls, spectrum);
}

void check_linear(const Start& start) {
  const scenario::Plan& plan = start.plan;
  for (const ObservedColumn& column : start.spectrum.observed)
    if (!is_of_motion(plan, column.probe))
      throw Error(fmt::format(
          "{}: '{}' is of a probe that reads contacts or energies, which has no linear response; observe positions, "
          "such as a strain, or leave the method linear out",
          column.place, column.name));
  response::check_laws(start.scene, response::LawsNeeded::any);
  if (start.spectrum.linear.step_of_run) response::check_integration(start.scene);
}

MethodSpectrum without_linearity(MethodSpectrum spectrum) {
  for (MethodSpectrum::Column& column : spectrum.columns) column.linearity.clear();
  return spectrum;
}

bool add_linear(const Start& start, MethodSpectrum& spectrum, const std::function<void()>& on_part) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const SpectrumPlan& plan = start.spectrum;
  check_linear(start);
  Simulation present(start.scene, start.state);
  const response::Rest rest =
      response::rest_of(present, assembly_of(plan), [&start] { return start.proceeds(); });
  if (!start.proceeds()) return false;
  Simulation& simulation = rest.equilibrium ? *rest.equilibrium : present;
  const DrivenWalls walls(start);
  spectrum.method = "linear";
  spectrum.columns.resize(plan.observed.size());
  if (spectrum.frequencies.empty() && !rest.warning.empty())
    spectrum.notes.push_back("linear: " + rest.warning);
  const bool complete = add_all_frequencies(start, simulation, walls, on_part, spectrum);
  spectrum.wall_time += std::chrono::duration<double>(Clock::now() - began).count();
  if (!complete) return false;
  check_columns(start, simulation, walls, spectrum);
  spectrum = without_linearity(std::move(spectrum));
  return true;
}

MethodSpectrum linear_spectrum(const Start& start) {
  MethodSpectrum spectrum;
  if (!add_linear(start, spectrum))
    throw Error("interrupted while the linear response was solved", ExitStatus::interrupted);
  return spectrum;
}

}  // namespace scree::spectrum
