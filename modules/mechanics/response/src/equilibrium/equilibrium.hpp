#pragma once

#include "assembly/body_force_terms.hpp"
#include "equilibrium/static_contacts.hpp"
#include "equilibrium/stiffness_factors.hpp"

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/SparseCore>

namespace scree::response {

// A packing after a motion, and whether its forces and torques are in balance.
struct Balance {
  bool found = false;
  Eigen::VectorXd motion;  // numbered by Equilibrium::freedom
  StaticConfiguration at;
  StaticLoads loads;
};

// Searches for the motion that brings a packing into balance, by Newton's method with the derivatives of the laws.
class Equilibrium {
 public:
  // tolerance: as QuasiStaticOptions. Throws Error if a law has no derivatives.
  Equilibrium(const Simulation& simulation, double tolerance);

  const DegreesOfFreedom& freedom() const { return freedom_; }
  const StaticContacts& contacts() const { return contacts_; }
  std::size_t iterations() const { return iterations_; }  // so far

  // From a configuration, under the loads on walls at a time (s). guess: a motion, or empty. Motions that leave the known pairs of
  // contacts behind are not looked for, and nothing once `proceed` returns false.
  Balance find(const StaticConfiguration& from, double time, const Eigen::VectorXd& guess,
               const std::function<bool()>& proceed);
  // The balance that was found becomes the present state.
  void accept(const Balance& balance);

  // A motion without that of bodies which touched nothing in the last evaluation: without inertia they do not go on.
  Eigen::VectorXd of_touched(Eigen::VectorXd motion) const;

 private:
  using Vector = Eigen::VectorXd;
  using Sparse = Eigen::SparseMatrix<double>;

  // One search.
  struct Search {
    const StaticConfiguration& from;
    double time;  // (s)
    Balance balance;
    WallEquations walls;  // where the last evaluation has them
  };
  // Forces and torques that are not in balance after the motion.
  Vector evaluate(Search& search);
  void add_bodies(const Search& search, Vector& residual) const;
  void add_walls(const Search& search, Vector& residual) const;
  // Moves on by the largest share of a step, `shortest` or more, that makes the residual smaller by `gain` times this share: where contacts change between
  // sticking and sliding, the whole step may not. Returns this share, 0 if there is none.
  double move_along(Search& search, const Vector& step, double shortest, double gain, Vector& residual);
  Sparse stiffness(const WallEquations& walls) const;  // K of the last evaluation
  // That K with `grounding` of its largest entry on its diagonal. Returns false if it is singular.
  bool factorise(const WallEquations& walls, double grounding);
  Vector step_for(const Vector& residual) const;
  // Translation and rotation of each body: its first number, and how many.
  template <class Visit>
  void for_each_motion(const Visit& visit) const {
    for (std::size_t i = 0; i < freedom_.bodies(); ++i) {
      visit(freedom_.translation(i, 0), freedom_.dimension());
      if (freedom_.spins() > 0) visit(freedom_.rotation(i, 0), freedom_.spins());
    }
  }

  double largest_force(const WallEquations& walls) const;
  double size_of(const Vector& residual) const { return residual.cwiseProduct(scale_).norm(); }
  // Largest displacement of a body, its surface or a wall (m).
  double length_of(const Vector& motion) const;

  const Simulation& simulation_;
  double tolerance_;
  WallEquations walls_at_start_;
  DegreesOfFreedom freedom_;
  StaticContacts contacts_;
  StiffnessFactors factors_;                 // also of earlier searches, as long as its steps converge fast
  std::vector<BodyForceTerms> body_forces_;  // empty if there are none at rest
  std::vector<Vec3> at_start_;               // (m) bodies and walls
  // 1 for forces, 1/R for torques: makes them forces, and rotations over it lengths.
  Vector scale_;
  double smallest_radius_, moved_ = 0;  // (m) since pairs were searched for
  std::size_t iterations_ = 0;
};

}  // namespace scree::response
