#pragma once

#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// The nearest step (s) that divides the durations of all stages, so that every run ends at the same time; the
// step itself if no stage has a duration, or if there is no common divisor.
double fitting_step(const scenario::Plan& plan, double step);

// Whether the step divides all durations.
bool divides_durations(const scenario::Plan& plan, double step);

}  // namespace scree::accuracy
