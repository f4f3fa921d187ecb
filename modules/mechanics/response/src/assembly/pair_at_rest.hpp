#pragma once

#include "assembly/contact_geometry.hpp"

#include <cstdint>
#include <type_traits>

#include <scree/contact_columns.hpp>
#include <scree/contact_kinematics.hpp>
#include <scree/orientations.hpp>
#include <scree/particles.hpp>
#include <scree/surface_place.hpp>

namespace scree::response {

// Distances from the centres to the point where the force of a pair acts (m); 0 for a wall.
using Levers = LeverArms<false>;

Eigen::Matrix3d matrix_of(const Matrix3& rows);

// A pair of bodies, or of a body and a wall, and where it is.
struct PairAtRest {
  std::uint32_t a, b;         // as in ContactList
  double radius_a, radius_b;  // (m); of a wall 0
  double effective_radius;    // (m)
  double distance;            // (m) between centres, or from centre to wall
  Vec3 normal, separation;    // as SCREE_NORMAL, SCREE_SEPARATION (m)
  PairVariation change;
  Vec3 crossed = {};                         // (m) periods that a has crossed, beside a surface
  Vec<4> wall_orientation = {{1, 0, 0, 0}};  // quaternion of a surface

  // Radii from the particles; effective radius of bodies or a plane.
  PairAtRest(const Particles& particles, std::uint32_t a, std::uint32_t b);
  // Two bodies by their separation.
  void set_between_bodies(const Vec3& between);
  // A body at a surface, by its centre from the origin of the frame of the surface.
  void set_at_surface(const SurfacePlace& place, const Vec3& from_origin);

  bool to_wall() const { return !(radius_b > 0); }
  double radius_sum() const { return radius_a + radius_b; }
  double radius_difference() const { return radius_a - radius_b; }
  double overlap() const { return radius_sum() - distance; }
  PairDirection<3> direction() const { return {normal, distance}; }
  Levers lever_arms(scree_arms arms) const { return lever_arms(arms, distance); }
  // The same with the centres at another distance.
  Levers lever_arms(scree_arms arms, double at_distance) const;
  ContactGeometry geometry(int dimension, int spins, scree_arms arms) const;

  // Sets the inputs of a law that follow from the place of the pair, orientations included if the law reads
  // them. Histories and motions stay as they are.
  void set_inputs(const Particles& particles, const Orientations& orientations, std::uint32_t reads,
                  ContactColumns& columns, std::size_t i) const;

 protected:
  // Calls use(plane) with std::true_type for a wall, else with std::false_type.
  template <class Use>
  auto with_kind(const Use& use) const {
    return to_wall() ? use(std::true_type()) : use(std::false_type());
  }

 private:
  void set_orientations(const Orientations& orientations, ContactColumns& columns, std::size_t i) const;
};

}  // namespace scree::response
