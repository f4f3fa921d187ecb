#pragma once

#include <scree/contact_list.hpp>
#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Have a view show bodies in their order in memory, or contacts; both must outlive it.
void show(const Particles& bodies, scree_view& view);
void show(const ContactList& contacts, scree_view& view);

}  // namespace scree
