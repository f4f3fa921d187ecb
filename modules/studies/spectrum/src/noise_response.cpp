#include "noise_response.hpp"

#include <cmath>

#include <scree/signals/transfer_function.hpp>

namespace scree::spectrum {

namespace {

using signals::TransferFunction;

TransferFunction transfer_of(const PulseRecord& record, std::size_t column, double step_hz) {
  std::vector<double> times(record.samples());
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = double(k) * record.interval();
  const auto segment = std::size_t(std::round(2 / (step_hz * record.interval())));
  return signals::transfer_function(times, record.drive(), record.column(column), segment);
}

}  // namespace

void add_noise_response(const PulseRecord& full, const PulseRecord& half, const scenario::SpectrumPlan& plan,
                        RoadSpectrum& road) {
  road.columns.resize(plan.observed.size());
  road.frequencies.clear();
  for (std::size_t c = 0; c < plan.observed.size(); ++c) {
    const TransferFunction h = transfer_of(full, c, plan.step_hz), weak = transfer_of(half, c, plan.step_hz);
    const double scale = plan.observed[c].relative ? 1 / std::abs(full.at_start(c)) : 1;
    const double slack = 1e-6 * plan.step_hz;
    for (std::size_t k = 2; k + 2 < h.h1.size(); k += 2) {
      const double f = h.frequency(k);
      if (f < plan.from_hz - slack || f > plan.to_hz + slack) continue;
      if (c == 0) road.frequencies.push_back(f);
      const double leakage = std::abs(h.h1[k + 2] - 2.0 * h.h1[k] + h.h1[k - 2]) / 24;
      road.columns[c].response.push_back(scale * h.h1[k]);
      road.columns[c].error.push_back(scale * std::hypot(std::abs(h.h1[k]) * h.error[k], leakage));
      road.columns[c].linearity.push_back(scale * std::abs(h.h1[k] - weak.h1[k]));
    }
  }
}

}  // namespace scree::spectrum
