#include "tone_halves.hpp"

#include <algorithm>
#include <cmath>

namespace scree::spectrum {

namespace {

constexpr double fewest_periods = 3, fewest_samples = 12;  // of a half
constexpr double many_errors = 5;

}  // namespace

ToneHalves::ToneHalves(const scenario::SpectrumPlan& plan, double frequency, double middle)
    : plan_(plan), middle_(middle) {
  const double periods = 0.5 * plan.analysed_periods;
  if (periods < fewest_periods || periods * plan.samples_per_period < fewest_samples) return;
  // The mean over a period would take one of few.
  first_.emplace(plan, frequency, periods, false);
  second_.emplace(plan, frequency, periods, false);
}

void ToneHalves::add(double time, double drive, const std::vector<double>& values) {
  if (first_) (time < middle_ ? first_ : second_)->add(time, drive, values);
}

bool ToneHalves::differ(const std::vector<double>& scales) const {
  if (!first_) return false;
  const std::vector<SweepPoint::Column> before = first_->columns(), after = second_->columns();
  for (std::size_t c = 0; c < scales.size(); ++c) {
    const double change = std::abs(after[c].response - before[c].response),
                 response = std::max(std::abs(after[c].response), scales[c]);
    if (change > plan_.tolerance * response &&
        change > many_errors * std::hypot(before[c].error, after[c].error))
      return true;
  }
  return false;
}

}  // namespace scree::spectrum
