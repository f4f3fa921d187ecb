#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/scene.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// What is wrong with a highest frequency (Hz) and a time step (s); nothing if a sample per step determines its sine.
std::optional<std::string> sampling_problem(double to_hz, double step);

// A line "<what>; <cure>" for each function of time that reaches half the sampling rate of one value per step. Beyond
// that it acts as a lower frequency, or not at all. Tables and ramps have no such frequency.
std::vector<std::string> undersampled_drives(const Scene& scene, const std::vector<Stage>& stages);

}  // namespace scree::scenario
