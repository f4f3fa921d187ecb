#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"
#include "walls/boundaries.hpp"

#include <vector>

#include <scree/body_column.hpp>
#include <scree/contact_list.hpp>

namespace scree {

// Which pairs a list has: pairs that touch at the present positions, or also pairs between which the last
// evaluation, at other positions, found a force; their overlap may be below 0.
enum class ListedPairs { touching, touching_or_loaded };

// Pairs at the present positions, with the forces (N) of the last evaluation.
struct PairsNow {
  const Particles& particles;
  const Contacts& contacts;
  const PairColumns& forces;
  const std::vector<LawInstance>& laws;
  const Boundaries& boundaries;
};
// In scene order, with bodies by number.
ContactList touching_contacts(const PairsNow& now, ListedPairs listed = ListedPairs::touching);
// The touching pairs of a tile in the order of memory, with bodies by place.
ContactList touching_contacts_of(const PairsNow& now, std::size_t tile);

// Number of pairs that touch at the present positions.
std::size_t count_touching(const Particles& particles, const Contacts& contacts,
                           const Boundaries& boundaries);
// Adds the number of these of each body, by place.
void count_contacts(const Particles& particles, const Contacts& contacts, const Boundaries& boundaries,
                    BodyColumn<std::uint32_t>& counts);

}  // namespace scree
