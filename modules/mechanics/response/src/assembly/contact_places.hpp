#pragma once

#include "assembly/pair_at_rest.hpp"

#include <cstddef>
#include <cstdint>

#include <scree/contact_list.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// Where the contacts of a list are.
class ContactPlaces {
 public:
  ContactPlaces(const Simulation& simulation, const ContactList& list)
      : simulation_(simulation), list_(list) {}

  PairAtRest pair(std::size_t contact) const;
  // Of a body (m), inside the periodic domain.
  Vec3 place_of(std::uint32_t body) const;

 private:
  Vec3 position_of(std::uint32_t body) const;
  Vec3 crossed_by(std::uint32_t body) const;  // (m) periods
  Vec3 from_plane(const PairAtRest& pair) const;
  BodyAtSurface at_surface(const PairAtRest& pair, std::size_t surface) const;

  const Simulation& simulation_;
  const ContactList& list_;
};

}  // namespace scree::response
