#include "steps.hpp"

#include <algorithm>
#include <cmath>

namespace scree::accuracy {

double fitting_step(const scenario::Plan& plan, double step) {
  constexpr double rounding = 1e-9;
  double shortest = 0;
  for (const Stage& stage : plan.stages)
    if (stage.duration && (shortest == 0 || *stage.duration < shortest)) shortest = *stage.duration;
  if (shortest == 0) return step;
  const double fitting = shortest / std::max(1.0, std::ceil(shortest / step * (1 - rounding)));
  for (const Stage& stage : plan.stages) {
    const double steps = stage.duration.value_or(0) / fitting;
    if (std::abs(steps - std::round(steps)) > rounding * std::max(1.0, steps)) return step;
  }
  return fitting;
}

}  // namespace scree::accuracy
