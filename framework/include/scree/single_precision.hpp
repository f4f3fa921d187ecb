#pragma once

#include <optional>
#include <string>

#include <scree/scene.hpp>

namespace scree {

// What laws and histories of a scene would compute in single precision that leaves its range, with the
// numbers; nothing if all typical magnitudes, and those products that laws form of them, are inside.
std::optional<std::string> single_precision_problem(const Scene& scene);

}  // namespace scree
