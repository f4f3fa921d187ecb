#pragma once

namespace scree {
class Error;
}

namespace scree::response {

// A matrix A counts as singular for a load f where |A| |A⁻¹ f|/|f| is larger: at most four digits are left. A
// motion that nothing resists and that the load does not move does no harm.
inline constexpr double largest_amplification = 1e12;

// Why there is no response at a frequency.
Error singular_at(double frequency_hz);

}  // namespace scree::response
