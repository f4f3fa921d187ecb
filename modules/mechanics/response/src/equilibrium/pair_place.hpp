#pragma once

#include "assembly/pair_at_rest.hpp"
#include "equilibrium/static_configuration.hpp"

#include <cstdint>
#include <optional>

#include <scree/plugin/rotation.hpp>

namespace scree::response {

// A pair of bodies, or of a body and a wall.
struct StaticPair {
  std::uint32_t a, b;                    // as in ContactList
  Vec3 shift;                            // (m) added to x_a − x_b of bodies, for the nearest images
  std::optional<SurfaceSpot> spot = {};  // on a mesh, at the beginning of the increment
};

enum class PairStatus : std::uint8_t { open, sticks, slides };

// A pair after an evaluation. A change of its status is an event.
struct PairState {
  PairStatus status = PairStatus::open;
  double overlap = 0;    // (m) below 0 where the pair does not touch
  double mobilised = 0;  // tangential over normal force; 0 where the pair does not touch
};

// A pair on a mesh after an increment.
struct MeshContact {
  std::optional<SurfacePlace> place;  // none if its spot is no more within the reach
  bool touched;                       // at the beginning of the increment
};

// Where a pair is at the end of an increment, and how it came there: the kinematics of a step of length 1.
struct PairPlace : PairAtRest {
  PairStep<3> motion;       // displacement of a's centre relative to b's (m), rotations (rad)
  PairDirection<3> middle;  // in the middle of the increment
  // Derivatives of the middle by the place of a there (1/m), at the end (1).
  Matrix3 middle_change;
  Vec3 middle_distance_change;
  std::optional<SurfaceSpot> spot = {};  // on a mesh

  // on_mesh: if the pair has a spot.
  PairPlace(const Simulation& simulation, const StaticPair& pair, const StaticConfiguration& after,
            const StaticMotion& motion, const MeshContact* on_mesh = nullptr);

  // Displacement of a's contact point relative to b's (m): with the normal at the end, and across that of the
  // middle.
  Vec3 slip(scree_arms arms) const { return slip(direction(), arms); }
  Vec3 tangential_increment(scree_arms arms) const;
  SlipDerivative slip_derivative(scree_arms arms) const;

 private:
  double approach() const { return -dot(motion.velocity, normal); }
  // Share of the increment during which the pair touches.
  double touched() const { return touched_share(overlap(), approach()); }
  void set_between();
  void set_at_plane(const scree_plane& plane);
  void set_at_surface(const WallSurfaces& all, std::size_t surface, int dimension);
  void set_on_mesh(const SurfaceSpot& before, const MeshContact& contact, const Rotation& to_scene);
  // With the normal there; the middle is as far from the surface as the end, less the way since then.
  void set_middle(const Vec3& middle_normal);
  Vec3 slip(const PairDirection<3>& at, scree_arms arms) const;
};

}  // namespace scree::response
