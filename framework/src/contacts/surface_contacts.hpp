#pragma once

#include "contacts/contacts.hpp"
#include "contacts/kernel/surface_records.hpp"
#include "contacts/pair_constants.hpp"
#include "surfaces/placed_surface.hpp"

#include <vector>

#include <scree/particles.hpp>

namespace scree {

// What the pairs of bodies and surfaces need besides the records of bodies.
class SurfaceContacts {
 public:
  // Makes room for the pairs; must be called after each neighbour search.
  void plan(const Contacts& contacts, std::size_t record_width);
  // The surfaces of an evaluation, which are numbered behind `planes` planes.
  void place(std::vector<PlacedSurface> surfaces, std::size_t planes);
  bool any() const { return any_; }
  // Finds the nearest points for the pairs of a tile, and the effective radii of its Hertzian contacts.
  void resolve(std::size_t tile, const Contacts& contacts, const Particles& particles,
               PairConstants& constants);
  const kernel::SurfaceRecords& records() const { return records_; }

 private:
  void resolve_pair(std::size_t pair, std::size_t row, const Contacts& contacts, const Particles& particles,
                    double* effective_radius);

  bool any_ = false;
  std::size_t planes_ = 0;
  std::vector<PlacedSurface> surfaces_;
  kernel::SurfaceRecords records_;
};

}  // namespace scree
