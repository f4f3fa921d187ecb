#pragma once

#include "assembly/contact_terms.hpp"
#include "assembly/slip_derivative.hpp"

#include <Eigen/Core>

#include <scree/contact_jacobian.hpp>

namespace scree::response {

// How the motion of two bodies moves their contact point, and how its force turns them. With n: normal,
// l: lever arms, u = u_a − u_b, w = l_a θ_a + l_b θ_b, X: matrix of θ ↦ n × θ,
//   u + X w                displacement of a's contact point relative to b's
//   l Xᵀ f ± c             torques
struct ContactGeometry {
  int dimension, spins;
  Eigen::Vector3d normal;
  double arm_a, arm_b;      // (m)
  double inverse_distance;  // (1/m) 0 for a wall
  bool arms_change;         // arms end at the contact point, which moves with half the overlap

  // Derivatives of force and couple on a with the motion of the contact, (D, ...) and (S, ...).
  struct Motion {
    Block force_by_displacement, couple_by_displacement;  // u
    Block force_by_turning, couple_by_turning;            // w
    Block force_by_rotation_a, couple_by_rotation_a;      // θ_a
    Block force_by_rotation_b, couple_by_rotation_b;      // θ_b
  };
  // From the Jacobians of many contacts, of the one with index i.
  Motion displacements(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // The same at the end of a motion, with which the tangential increment changes as `slip` says.
  Motion displacements(const ContactJacobian& columns, const double* jacobians, std::size_t i,
                       const SlipDerivative& slip) const;
  Motion velocities(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // Of the spins alone, where the force depends on them: couples alone are rolling resistance.
  Motion spins_of(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // Negative derivatives of forces and torques on a and b with their displacements and rotations. `force` (N)
  // on a turns with the normal; with zero force the same holds for velocities.
  Block of_bodies(const Motion& motion, const Eigen::Vector3d& force) const;

  // Matrix (D, S) of θ ↦ v × θ.
  Block crossing(const Eigen::Vector3d& v) const;

 private:
  // Rows of force and couple in the Jacobian of contact i, columns of a motion.
  struct Part {
    Block force, couple;
  };
  Part part(const ContactJacobian& columns, const double* jacobians, std::size_t i, PairMotion motion) const;
  // Derivative of l (n × ·)ᵀ f with u, at constant f: normal and arm change. (S, D)
  Block turning_of_lever(double arm, const Eigen::Vector3d& force) const;
};

}  // namespace scree::response
