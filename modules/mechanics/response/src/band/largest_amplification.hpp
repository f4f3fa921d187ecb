#pragma once

namespace scree::response {

// Of |A| |A⁻¹ f|/|f|: above it A counts as singular for the load f, since at most four digits are left. A motion that nothing resists
// and that the load does not move does no harm.
inline constexpr double largest_amplification = 1e12;

}  // namespace scree::response
