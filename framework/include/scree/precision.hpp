#pragma once

namespace scree {

// Precision of contact evaluation and of contact histories: `mixed` uses float for both. Positions,
// velocities and sums are always double.
enum class Precision { double_precision, mixed };

}  // namespace scree
