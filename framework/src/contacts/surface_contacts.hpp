#pragma once

#include "contacts/contacts.hpp"
#include "contacts/kernel/surface_records.hpp"
#include "contacts/mesh_spots.hpp"
#include "contacts/pair_constants.hpp"
#include "contacts/shape_contacts.hpp"
#include "surfaces/placed_surface.hpp"
#include "surfaces/sliding_work.hpp"

#include <cstdint>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>

namespace scree {

// What the pairs of bodies and surfaces need besides the records of bodies.
class SurfaceContacts {
 public:
  // Makes room for the pairs; must be called after each neighbour search.
  void plan(const Contacts& contacts, std::size_t record_width, const kernel::SurfaceRecords::Kept& kept);
  // The surfaces of an evaluation, which are numbered behind `planes` planes, at the end of a step (s).
  // Bodies meet them where they are in the periodic domain.
  void place(std::vector<PlacedSurface> surfaces, std::size_t planes, const Domain& domain, double step);
  bool any() const { return any_; }
  // Finds the nearest points for the pairs of a tile, and the effective radii of its Hertzian contacts.
  // Histories follow the spots of meshes. springs: of each law, whether its histories begin with one.
  void resolve(std::size_t tile, Contacts& contacts, const Particles& particles,
               const std::vector<std::uint8_t>& springs, PairConstants& constants);
  const kernel::SurfaceRecords& records() const { return records_; }
  double* slips() { return records_.slips(); }
  // Where friction has dissipated energy in the last evaluation of a tile; below 0 in a step backwards.
  std::vector<SlidingWork::Slip> slips_of(std::size_t tile, const Contacts& contacts, const SlidingWork& on,
                                          int dimension, bool backwards);

 private:
  // The pairs of a body and a mesh.
  struct PairsOfBody {
    const PlacedSurface& surface;
    std::uint32_t body, wall;
    std::size_t begin, end;
    bool spring;
  };
  // Where what is found is written.
  struct Results {
    std::size_t rows;          // of records, less the pairs
    double* effective_radius;  // of all pairs, or null
  };
  void resolve_spots(const PairsOfBody& of, const Results& to, const Particles& p, MeshSpots& mesh_spots,
                     PairGroup& group);
  // Then there are no bodies left.
  void resolve_shape(const PlacedSurface& surface, const Results& to, const Particles& p,
                     ShapeContacts& bodies);
  // A pair without a spot, which is far away until it has one.
  void set_away(std::size_t row, const PairsOfBody& of, const Vec3& x, const Particles& p);
  // beyond: (m) periods by which the body lies beyond the domain.
  void set(std::size_t row, const PlacedSurface& surface, SurfacePoint at, const Vec3& beyond,
           const Particles& p);
  // What laws that follow bodies along the surface read. x: (m) centre of the body, nearest: nearest point,
  // both in the frame of the surface.
  void set_path(std::size_t row, const PlacedSurface& surface, int dimension, const Vec3& x,
                const NearestPoint& nearest);

  bool any_ = false;
  std::size_t planes_ = 0;
  double step_ = 0;
  Domain domain_;
  std::vector<PlacedSurface> surfaces_;
  kernel::SurfaceRecords records_;
  std::vector<std::uint8_t> away_;     // of each row
  std::vector<MeshSpots> mesh_spots_;  // of each tile
};

}  // namespace scree
