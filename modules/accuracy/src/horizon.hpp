#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include <scree/scenario/plan.hpp>

namespace scree::accuracy {

// Runs a plan with a step and with half of it side by side, compares them at multiples of `interval` (s,
// itself a multiple of the step), and returns the last of these until which the bodies are within `distance`
// (m, root mean square) of each other; nothing if they are to the end.
std::optional<double> trustworthy_until(const scenario::Plan& plan, double step, double interval,
                                        double distance, const std::function<void(double share)>& on_progress,
                                        const std::atomic<bool>* stop);

// Sum over the stages, of those that end by a condition the longest they may take (s).
double longest_duration(const scenario::Plan& plan);

// Root mean square distance of two sets of positions (m).
double distance_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace scree::accuracy
