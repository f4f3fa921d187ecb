#pragma once

#include "assembly/turn_terms.hpp"
#include "static/static_solution.hpp"

#include <functional>
#include <memory>
#include <vector>

#include <scree/wall_equations.hpp>

namespace scree::response {

// A static displacement of a packing.
struct PackingMotion {
  Eigen::VectorXd motion;  // q, numbered by LinearSystem::freedom
  Eigen::VectorXd walls;   // w (m) (walls × dimension), in addition
  double residual;         // of K q = f
};

// Solves for the static displacements of a packing at rest, without their parts along floppy modes.
class StaticPacking {
 public:
  // Throws Error as assemble() does, or (interrupted) if `proceed` ends the search for floppy modes.
  StaticPacking(const Simulation& simulation, const AssemblyOptions& options,
                const std::function<bool()>& proceed);

  const LinearSystem& system() const { return system_; }
  const ContactList& list() const { return list_; }
  const std::vector<ContactTerms>& contacts() const { return terms_; }  // bodies that are left out included

  // The response to displacements of walls (m) (walls × dimension).
  PackingMotion displace(const Eigen::VectorXd& walls) const;
  // The response to a force of 1 N along the direction of a wall that forces move.
  PackingMotion load(std::size_t wall) const;

  // Whether ContactTerms::a or b is a wall or a body that is held.
  bool is_held(std::uint32_t end) const;
  // Component k of its displacement (m), then of its rotation (rad); a wall has no rotation here.
  double component(const PackingMotion& motion, std::uint32_t end, int k) const;
  // Change of the unit normal of a contact.
  Eigen::Vector3d normal_change(const PackingMotion& motion, const ContactTerms& contact) const;
  // Change of the force on body a (N).
  Eigen::VectorXd force_change(const PackingMotion& motion, const ContactTerms& contact) const;

 private:
  // Whether a contact is with a wall that torques turn; then its angle (rad), and where it touches.
  bool turns(const ContactTerms& contact) const;
  double angle(const PackingMotion& motion, const ContactTerms& contact) const;
  TurnedContact turned(const ContactTerms& contact) const;
  PackingMotion solve(const Eigen::VectorXd& force, const Eigen::VectorXd& walls) const;

  LinearSystem system_;
  UndampedSystem undamped_;
  std::unique_ptr<ShiftedFactors> inverse_;
  ContactList list_;
  std::vector<ContactTerms> terms_;
  WallEquations equations_;
  Eigen::MatrixXd floppy_;
};

}  // namespace scree::response
