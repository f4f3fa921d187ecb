#include "near_fit.hpp"

#include "mode_of_pole.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace scree::spectrum {

namespace {

// What is open in a fit of a mode; the others show what each changes.
struct Choice {
  double widths = reach;         // on each side
  int degree = 1;                // of the background
  bool background_poles = true;  // those that do not stand out
};
constexpr std::array<Choice, 5> alternatives = {{{.widths = 2},
                                                 {.widths = reach / 2},
                                                 {.degree = 2},
                                                 {.widths = 2, .degree = 2},
                                                 {.background_poles = false}}};

struct NearFit {
  Response response;
  ModeFit fit;
  Mode mode;
};

// Whether the fit is still of the mode that it began with.
bool is_same(const NearFit& near, const Pole& before) {
  const Pole& pole = near.fit.poles[0];
  return near.fit.converged && is_within(pole, near.response) &&
         std::abs(pole.frequency - before.frequency) < 0.5 * before.width && pole.width < 2 * before.width;
}

std::optional<NearFit> fit_near(const Response& whole, const std::vector<Group>& groups, std::size_t group,
                                std::size_t number, const Choice& choice) {
  const std::vector<Pole>& poles = groups[group].fit.poles;
  const Range range = range_about(whole, poles[number], choice.widths);
  if (range.end - range.begin < least_values) return {};
  NearFit near{alone(whole, groups, group, range), {}, {}};
  std::vector<Pole> inside = {poles[number]};
  for (std::size_t k = 0; k < poles.size(); ++k) {
    if (k == number) continue;
    const double distance = std::abs(poles[k].frequency - poles[number].frequency);
    if (distance >= choice.widths * poles[number].width)
      subtract(poles[k], near.response);
    else if (choice.background_poles || stands_out(groups[group].fit, k, whole.only_amplitudes))
      inside.push_back(poles[k]);
  }
  near.fit = fit_modes(near.response, inside, choice.degree);
  if (!is_same(near, poles[number])) return {};
  near.mode = mode_of(near.fit, 0, near.response);
  return near;
}

void cover_correlation(Mode& mode, double excess) {
  for (double* error : {&mode.frequency_error, &mode.width_error, &mode.quality_error, &mode.amplitude_error})
    *error *= std::sqrt(excess);
}

// Of the change by another choice: white noise passes three times in a thousand or less.
bool is_beyond_noise(const Mode& from, const Mode& to) {
  return std::abs(to.frequency - from.frequency) > 3 * to.frequency_error;
}

void cover_change(Mode& mode, const Mode& from, const Mode& to) {
  const auto add = [](double& error, double change) { error = std::hypot(error, change); };
  add(mode.frequency_error, to.frequency - from.frequency);
  add(mode.width_error, to.width - from.width);
  add(mode.quality_error, to.quality - from.quality);
  add(mode.amplitude_error, to.amplitude - from.amplitude);
}

}  // namespace

Mode near_mode(const Response& whole, const std::vector<Group>& groups, std::size_t group, std::size_t pole) {
  const ModeFit& wide = groups[group].fit;
  const Mode of_group = mode_of(wide, pole, part(whole, groups[group].range));
  std::optional<NearFit> near;
  if (!whole.only_amplitudes) near = fit_near(whole, groups, group, pole, {});
  Mode mode = near ? near->mode : of_group;
  const double excess = near ? near->fit.excess : wide.excess;
  cover_correlation(mode, excess);
  if (!near) return mode;
  if (excess > 1) cover_change(mode, near->mode, of_group);
  for (const Choice& choice : alternatives) {
    const auto other = fit_near(whole, groups, group, pole, choice);
    if (other && (excess > 1 || is_beyond_noise(near->mode, other->mode)))
      cover_change(mode, near->mode, other->mode);
  }
  return mode;
}

}  // namespace scree::spectrum
