#pragma once

#include <span>
#include <string>

#include <scree/plugin/abi.h>

namespace scree {

// Throws Error if a boundary plug-in describes itself in a way that the host cannot use: planes or axes that
// are not finite, names that are NULL.
void check_layout(const std::string& plugin, const scree_boundary_instance& instance, int dimension);

// Whether all numbers of a plane are finite.
bool is_finite(const scree_plane& plane);

// What is wrong with a plane as "<quantity> is <value>"; empty if it is finite and its normal a unit vector.
std::string problem_of(const scree_plane& plane);
// What a linear equation has that it must not have, "a mass of -1 kg"; empty if it is sound. stiffness: its
// row.
std::string problem_of(const scree_linear_wall& wall, std::span<const double> stiffness);

}  // namespace scree
