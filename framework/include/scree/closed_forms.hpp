#pragma once

#include <vector>

#include <scree/plugin_host.hpp>

namespace scree {

// The closed forms of a law for a pair of bodies. Throws Error with the name of the law if it states a form
// without a name, more of them than there is room for, or a contact time, critical step or Rayleigh time that
// is not above 0.
std::vector<scree_closed_form> closed_forms(const ConfiguredLaw& law, const scree_encounter& encounter);

}  // namespace scree
