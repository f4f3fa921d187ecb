#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// Runs a plan with a step and with half of it side by side, and returns the time (s) until which the bodies
// are within `distance` (m, root mean square) of each other; nothing if they are to the end.
std::optional<double> trustworthy_until(const scenario::Plan& plan, double step, double distance,
                                        const std::function<void(double share)>& on_progress,
                                        const std::atomic<bool>* stop);

// Root mean square distance of two sets of positions (m).
double distance_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace scree::accuracy
