#include "near_fit.hpp"

#include "mode_estimate.hpp"
#include "mode_of_pole.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace scree::signals {

namespace {

constexpr double reach_of_estimate = 6;   // widths on each side
constexpr double least_height = 0.5;      // of strong poles, over the height of this
constexpr double gain_of_pole = 40;       // of Akaike's criterion, by each pole that is fitted beside this
constexpr double most_over_response = 2;  // height, over the largest response within its width
constexpr double known_over_error = 2;    // of height and width

double height_of(const Pole& pole, const Response& response) {
  return std::abs(pole.strength * response.factor(pole.frequency)) / (pole.frequency * pole.width);
}

// The response about a pole, and the other poles there.
struct Surroundings {
  Response response;
  std::vector<Pole> strong, weak;
};

Surroundings surroundings(const Response& whole, const std::vector<Group>& groups, std::size_t group,
                          std::size_t number) {
  const Pole& pole = groups[group].fit.poles[number];
  Surroundings near{part(whole, range_about(whole, pole, reach_of_estimate)), {}, {}};
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].fit.converged) continue;
    const Response fitted = part(whole, groups[g].range);
    for (std::size_t k = 0; k < groups[g].fit.poles.size(); ++k) {
      const Pole& other = groups[g].fit.poles[k];
      if ((g == group && k == number) || (g != group && !is_within(other, fitted))) continue;
      if (std::abs(other.frequency - pole.frequency) >= reach_of_estimate * pole.width)
        subtract(other, near.response);
      else if (height_of(other, whole) >= least_height * height_of(pole, whole))
        near.strong.push_back(other);
      else
        near.weak.push_back(other);
    }
  }
  return near;
}

// Mean of estimates by their weights; errors also cover how they differ. All else is of the weightiest.
Mode mean_of(const std::vector<ModeEstimate>& estimates, const std::vector<double>& weights) {
  Mode mode = estimates[std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin())].mode;
  const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto average = [&](double Mode::*number, double Mode::*error) {
    double mean = 0, variance = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) mean += weights[k] / whole * estimates[k].mode.*number;
    for (std::size_t k = 0; k < weights.size(); ++k)
      variance += weights[k] / whole *
                  std::norm(std::complex(estimates[k].mode.*number - mean, estimates[k].mode.*error));
    mode.*number = mean, mode.*error = std::sqrt(variance);
  };
  average(&Mode::frequency, &Mode::frequency_error), average(&Mode::width, &Mode::width_error);
  average(&Mode::quality, &Mode::quality_error), average(&Mode::amplitude, &Mode::amplitude_error);
  return mode;
}

// Of a pole alone, beside the strong ones, and beside all, by the weights of Akaike.
std::optional<Mode> estimate_near(const Surroundings& near, const Pole& pole) {
  std::vector<std::vector<Pole>> choices = {{}};
  if (!near.strong.empty()) choices.push_back(near.strong);
  if (!near.weak.empty()) {
    choices.push_back(near.strong);
    choices.back().insert(choices.back().end(), near.weak.begin(), near.weak.end());
  }
  std::vector<ModeEstimate> estimates;
  std::vector<double> weights;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Pole>& beside : choices)
    if (auto estimate = estimate_mode(near.response, pole, beside)) {
      estimate->criterion += gain_of_pole * double(beside.size());
      least = std::min(least, estimate->criterion);
      estimates.push_back(*estimate);
    }
  if (estimates.empty()) return {};
  for (const ModeEstimate& estimate : estimates)  // infinite of all, if frequencies are few
    weights.push_back(estimate.criterion > least ? std::exp(0.5 * (least - estimate.criterion)) : 1);
  return mean_of(estimates, weights);
}

// Whether poles beside it take away most of the height of a mode, so that the response does not show it.
bool is_absurd(const Mode& mode, const Response& whole) {
  double largest = 0;
  for (std::size_t k = 0; k < whole.values.size(); ++k)
    if (std::abs(whole.frequencies[k] - mode.frequency) <= mode.width)
      largest = std::max(largest, std::abs(whole.values[k]));
  return mode.amplitude > most_over_response * largest;
}

void cover_correlation(Mode& mode, double excess) {
  for (double* error : {&mode.frequency_error, &mode.width_error, &mode.quality_error, &mode.amplitude_error})
    *error *= std::sqrt(excess);
}

}  // namespace

std::optional<Mode> near_mode(const Response& whole, const std::vector<Group>& groups, std::size_t group,
                              std::size_t pole) {
  const ModeFit& fit = groups[group].fit;
  std::optional<Mode> estimate;
  if (!whole.only_amplitudes)
    estimate = estimate_near(surroundings(whole, groups, group, pole), fit.poles[pole]);
  Mode mode = estimate ? *estimate : mode_of(fit, pole, part(whole, groups[group].range));
  if (!estimate) cover_correlation(mode, fit.excess);
  mode.together = fit.poles.size();
  const bool is_known = !(mode.amplitude < known_over_error * mode.amplitude_error) &&
                        !(mode.width < known_over_error * mode.width_error);
  return is_known && (whole.only_amplitudes || !is_absurd(mode, whole)) ? std::optional(mode) : std::nullopt;
}

}  // namespace scree::signals
