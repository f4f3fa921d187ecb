#pragma once

#include <scree/plugin/abi.h>

namespace scree {

// Whether two sets of parameters of a boundary give it the same surfaces.
bool same_surfaces(const scree_boundary_instance& one, const scree_boundary_instance& other);

}  // namespace scree
