#include "assembly/turn_terms.hpp"

#include <Eigen/Geometry>

namespace scree::response {

namespace {

// The components that a body has of a vector in its translation, and of one in its rotation.
TurnTerms::Vector of_motion(const TurnedContact& contact, const Eigen::Vector3d& translation,
                            const Eigen::Vector3d& rotation) {
  TurnTerms::Vector all(contact.dimension + contact.spins);
  all << translation.head(contact.dimension), rotation.segment(contact.dimension == 2 ? 2 : 0, contact.spins);
  return all;
}

}  // namespace

TurnedContact turned_contact(const ContactTerms& contact, const scree_linear_wall& equation, int dimension,
                             int spins) {
  const Eigen::Vector3d axis(equation.axis);
  return {.dimension = dimension,
          .spins = spins,
          .axis = axis,
          .load_axis = contact.springs_twist
                           ? axis
                           : Eigen::Vector3d(axis - axis.dot(contact.normal) * contact.normal),
          .arm = contact.place - Eigen::Vector3d(equation.centre),
          .force = contact.force,
          .torque = contact.torque};
}

// When the wall alone turns by φ, all turn by φ about the centre, and with them force and torque, except that
// springs which slip alone moves stay where they are about the normal; then the body moves back by B φ,
// B = (a × s, a) with the axis a and the arm s. The torque on the wall is −a·(T + s × F).
TurnTerms turn_terms(const Block& of_body, const TurnedContact& contact) {
  const Eigen::Vector3d &axis = contact.axis, &force = contact.force;
  const TurnTerms::Vector back = of_motion(contact, axis.cross(contact.arm), axis);
  const TurnTerms::Vector turned =
      of_motion(contact, contact.load_axis.cross(force), contact.load_axis.cross(contact.torque));
  TurnTerms terms;
  terms.by_turn = -turned - of_body * back;
  terms.of_torque =
      of_motion(contact, force.cross(axis), Eigen::Vector3d::Zero()) - of_body.transpose() * back;
  terms.own = -back.dot(terms.by_turn);
  return terms;
}

}  // namespace scree::response
