#pragma once

#include "assembly/contact_terms.hpp"

#include <Eigen/Core>

#include <scree/contact_jacobian.hpp>

namespace scree::response {

// Derivatives of the tangential increment of a pair with the end of a motion: by the displacement of a
// relative to b, and by the rotations of both.
struct SlipDerivative {
  Eigen::Matrix3d by_displacement, by_rotation_a, by_rotation_b;
};

// How the motion of two bodies moves their contact point, and how the contact force turns them. With the
// normal n, the lever arms l, u = u_a − u_b, w = l_a θ_a + l_b θ_b and the matrix X of θ ↦ n × θ,
//   u + X w                displacement of a's contact point relative to b's
//   l Xᵀ f ± c             torques
struct ContactGeometry {
  int dimension, spins;
  Eigen::Vector3d normal;
  double arm_a, arm_b;            // (m)
  Eigen::Matrix3d normal_change;  // (1/m) derivative of the normal by u
  bool arms_change;               // arms end at the contact point, which moves with half the overlap

  // Derivatives of force (D, ...) and couple (S, ...) on a by the motion of the contact.
  struct Motion {
    Block force_by_displacement, couple_by_displacement;  // u
    Block force_by_turning, couple_by_turning;            // w
    Block force_by_rotation_a, couple_by_rotation_a;      // θ_a
    Block force_by_rotation_b, couple_by_rotation_b;      // θ_b
  };
  // From the Jacobians of many contacts, for contact i.
  Motion displacements(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // The same at the end of a motion that changes the tangential increment by `slip`.
  Motion displacements(const ContactJacobian& columns, const double* jacobians, std::size_t i,
                       const SlipDerivative& slip) const;
  Motion velocities(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // By the spins alone if the force depends on them. Couples without a force are rolling resistance and count
  // as 0.
  Motion spins_of(const ContactJacobian& columns, const double* jacobians, std::size_t i) const;
  // Negative derivatives of forces and torques on a and b by their displacements and rotations. The force on
  // a (N) turns with the normal; with zero force, derivatives by velocities and spins.
  Block of_bodies(const Motion& motion, const Eigen::Vector3d& force) const;

  // Matrix (D, S) of θ ↦ v × θ.
  Block crossing(const Eigen::Vector3d& v) const;

 private:
  // Rows of force and couple in the Jacobian of contact i, columns of a motion.
  struct Part {
    Block force, couple;
  };
  Part part(const ContactJacobian& columns, const double* jacobians, std::size_t i, PairMotion motion) const;
  // (S, D) derivative of l (n × ·)ᵀ f by u at constant f: normal and arm change.
  Block turning_of_lever(double arm, const Eigen::Vector3d& force) const;
};

}  // namespace scree::response
