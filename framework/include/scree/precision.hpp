#pragma once

namespace scree {

// In what numbers contacts are evaluated and their histories kept; positions, velocities and sums are always
// double.
enum class Precision { double_precision, mixed };

}  // namespace scree
