#pragma once

#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// The nearest step that divides the durations of all stages that have one, so that every run ends at the same
// time; the step itself where there are none, or they have no common measure (s).
double fitting_step(const scenario::Plan& plan, double step);

// Whether it divides them all.
bool divides_durations(const scenario::Plan& plan, double step);

}  // namespace scree::accuracy
