#pragma once

#include <string>
#include <vector>

#include <scree/scene.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// A line "<what>; <cure>" for each function of time that reaches half the sampling rate of a value per step, beyond which it acts
// as one of a lower frequency, or not at all. Tables and ramps have no such frequency.
std::vector<std::string> undersampled_drives(const Scene& scene, const std::vector<Stage>& stages);

}  // namespace scree::scenario
