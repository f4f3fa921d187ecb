#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"

#include <vector>

#include <scree/contact_list.hpp>
#include <scree/domain.hpp>

namespace scree {

// All touching pairs at the present positions, with the forces of the last evaluation.
ContactList touching_contacts(const Particles& particles, const Contacts& contacts, const Forces& forces,
                              const std::vector<LawInstance>& laws, const std::vector<scree_plane>& planes,
                              const Domain& domain);

}  // namespace scree
