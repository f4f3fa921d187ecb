#pragma once

#include "assembly/contact_terms.hpp"

#include <vector>

namespace scree::response {

// Whether each body is held by at least as many contacts with held bodies or walls as AssemblyOptions ask for.
std::vector<bool> held_bodies(const std::vector<ContactTerms>& contacts, std::size_t bodies, int dimension,
                              int fewest_contacts);

}  // namespace scree::response
