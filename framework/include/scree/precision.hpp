#pragma once

namespace scree {

// Precision of contact evaluation and of contact histories: `mixed` uses float for both. Positions,
// velocities and sums are always double.
enum class Precision { double_precision, mixed };

// As in a scenario: time.precision.
constexpr const char* precision_name(Precision precision) {
  return precision == Precision::mixed ? "mixed" : "double";
}

}  // namespace scree
