#pragma once

#include "assembly/contact_terms.hpp"

#include <Eigen/Core>

namespace scree::response {

// A contact of a body with a wall that turns by φ about an axis.
struct TurnedContact {
  int dimension, spins;
  Eigen::Vector3d axis;           // unit
  Eigen::Vector3d load_axis;      // about which force and torque turn when body and wall turn together
  Eigen::Vector3d arm;            // (m) from the centre of the turn to the body
  Eigen::Vector3d force, torque;  // on the body (N), (N m); 0 for derivatives by velocities and spins
};

// Negative derivatives of a contact by φ, and of the torque on the wall about the axis. Those by a
// translation of the wall, and of the force on the wall, are opposite to those of the body.
struct TurnTerms {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
  Vector by_turn;    // of force and torque on the body
  Vector of_torque;  // by displacement and rotation of the body
  double own;        // of the torque by φ
};

// equation: of the wall, which turns.
TurnedContact turned_contact(const ContactTerms& contact, const scree_linear_wall& equation, int dimension,
                             int spins);

// of_body: negative derivatives of force and torque on the body by its own motion.
TurnTerms turn_terms(const Block& of_body, const TurnedContact& contact);

}  // namespace scree::response
