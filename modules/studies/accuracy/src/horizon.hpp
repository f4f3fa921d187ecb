#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// Runs a plan with a step and with half of it, and compares the positions at multiples of `interval` (s,
// itself a multiple of the step). Returns the last of these times up to which they agree within `distance`
// (m, root mean square); empty if they agree to the end.
std::optional<double> trustworthy_until(const scenario::Plan& plan, double step, double interval,
                                        double distance, const std::function<void(double share)>& on_progress,
                                        const std::atomic<bool>* stop);

// Sum of the durations of the stages (s); the maximum for stages that end by a condition.
double longest_duration(const scenario::Plan& plan);

// Root mean square distance between two sets of positions (m).
double distance_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace scree::accuracy
