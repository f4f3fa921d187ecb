#include "mode_group.hpp"

#include "mode_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace scree::signals {

namespace {

constexpr std::size_t least_points = 4;  // frequencies in the width of a mode

constexpr double reach_of_estimate = 6;   // widths on each side of the pole
constexpr double least_height = 0.5;      // of a strong pole, over the height of the pole
constexpr double penalty_of_pole = 40;    // on Akaike's criterion, for each pole that is fitted beside it
constexpr double most_over_response = 2;  // height, over the largest response within the width
constexpr double known_over_error = 2;    // height and width, over their errors

double height_of(const Pole& pole, const ResponseSpectrum& response) {
  return std::abs(pole.strength * response.factor(pole.frequency)) / (pole.frequency * pole.width);
}

// The response about a pole, and the other poles there.
struct Surroundings {
  ResponseSpectrum response;
  std::vector<Pole> strong, weak;
};

Surroundings surroundings(const ResponseSpectrum& whole, const std::vector<Group>& groups, std::size_t group,
                          std::size_t number) {
  const Pole& pole = groups[group].fit.poles[number];
  Surroundings near{slice(whole, range_about(whole, pole, reach_of_estimate)), {}, {}};
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].fit.converged) continue;
    const ResponseSpectrum fitted = slice(whole, groups[g].range);
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

// Weighted mean of estimates. Errors also cover how the estimates differ; the rest is of the one with most
// weight.
FittedMode mean_of(const std::vector<ModeEstimate>& estimates, const std::vector<double>& weights) {
  FittedMode mode =
      estimates[std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin())].mode;
  const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto average = [&](double FittedMode::*number, double FittedMode::*error) {
    double mean = 0, variance = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) mean += weights[k] / whole * estimates[k].mode.*number;
    for (std::size_t k = 0; k < weights.size(); ++k)
      variance += weights[k] / whole *
                  std::norm(std::complex(estimates[k].mode.*number - mean, estimates[k].mode.*error));
    mode.*number = mean, mode.*error = std::sqrt(variance);
  };
  average(&FittedMode::frequency, &FittedMode::frequency_error),
      average(&FittedMode::width, &FittedMode::width_error);
  average(&FittedMode::quality, &FittedMode::quality_error),
      average(&FittedMode::amplitude, &FittedMode::amplitude_error);
  return mode;
}

// The mean of three estimates by Akaike's weights: of the pole alone, beside the strong poles, and beside
// all.
std::optional<FittedMode> estimate_near(const Surroundings& near, const Pole& pole) {
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
      estimate->criterion += penalty_of_pole * double(beside.size());
      least = std::min(least, estimate->criterion);
      estimates.push_back(*estimate);
    }
  if (estimates.empty()) return {};
  for (const ModeEstimate& estimate : estimates)  // all criteria are infinite if frequencies are few
    weights.push_back(estimate.criterion > least ? std::exp(0.5 * (least - estimate.criterion)) : 1);
  return mean_of(estimates, weights);
}

// Whether the poles beside a mode cancel most of its height, so that the response does not show it.
bool is_absurd(const FittedMode& mode, const ResponseSpectrum& whole) {
  double largest = 0;
  for (std::size_t k = 0; k < whole.values.size(); ++k)
    if (std::abs(whole.frequencies[k] - mode.frequency) <= mode.width)
      largest = std::max(largest, std::abs(whole.values[k]));
  return mode.amplitude > most_over_response * largest;
}

void cover_correlation(FittedMode& mode, double excess) {
  for (double* error : {&mode.frequency_error, &mode.width_error, &mode.quality_error, &mode.amplitude_error})
    *error *= std::sqrt(excess);
}

}  // namespace

std::size_t index_of(const ResponseSpectrum& response, double frequency) {
  const auto& f = response.frequencies;
  return std::size_t(std::lower_bound(f.begin(), f.end(), frequency) - f.begin());
}

FitRange range_about(const ResponseSpectrum& response, const Pole& pole, double widths) {
  return {index_of(response, pole.frequency - widths * pole.width),
          index_of(response, pole.frequency + widths * pole.width),
          {pole}};
}

ResponseSpectrum slice(const ResponseSpectrum& whole, const FitRange& range) {
  const auto cut = [&](const auto& all) {
    return std::remove_cvref_t<decltype(all)>(all.begin() + std::ptrdiff_t(range.begin),
                                              all.begin() + std::ptrdiff_t(range.end));
  };
  return {cut(whole.frequencies), cut(whole.values), whole.only_amplitudes, whole.derivative};
}

bool is_within(const Pole& pole, const ResponseSpectrum& response) {
  const double low = response.frequencies.front(), high = response.frequencies.back();
  const std::size_t within = index_of(response, pole.frequency + 0.5 * pole.width) -
                             index_of(response, pole.frequency - 0.5 * pole.width);
  return pole.frequency > low && pole.frequency < high && within >= least_points && pole.width < high - low;
}

void subtract(const Pole& pole, ResponseSpectrum& response) {
  for (std::size_t k = 0; k < response.values.size(); ++k) {
    const double f = response.frequencies[k];
    response.values[k] -= response.factor(f) * pole.strength /
                          std::complex((pole.frequency - f) * (pole.frequency + f), f * pole.width);
  }
}

ResponseSpectrum without_other_groups(const ResponseSpectrum& whole, const std::vector<Group>& groups,
                                      std::size_t number, const FitRange& range) {
  ResponseSpectrum response = slice(whole, range);
  if (whole.only_amplitudes) return response;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g == number || !groups[g].fit.converged) continue;
    const ResponseSpectrum of_other = slice(whole, groups[g].range);
    for (const Pole& pole : groups[g].fit.poles)
      if (is_within(pole, of_other)) subtract(pole, response);
  }
  return response;
}

std::optional<FittedMode> refit_locally(const ResponseSpectrum& whole, const std::vector<Group>& groups,
                                        std::size_t group, std::size_t pole) {
  const ModeFit& fit = groups[group].fit;
  std::optional<FittedMode> estimate;
  if (!whole.only_amplitudes)
    estimate = estimate_near(surroundings(whole, groups, group, pole), fit.poles[pole]);
  FittedMode mode = estimate ? *estimate : mode_of(fit, pole, slice(whole, groups[group].range));
  if (!estimate) cover_correlation(mode, fit.excess);
  mode.together = fit.poles.size();
  const bool is_known = !(mode.amplitude < known_over_error * mode.amplitude_error) &&
                        !(mode.width < known_over_error * mode.width_error);
  return is_known && (whole.only_amplitudes || !is_absurd(mode, whole)) ? std::optional(mode) : std::nullopt;
}

}  // namespace scree::signals
