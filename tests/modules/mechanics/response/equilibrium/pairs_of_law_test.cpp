#include "increment.hpp"

#include <catch2/catch.hpp>

namespace scree::test {

// The last body first touches in the middle of the increment: its spring takes the part of the slip since
// then, which grows with the overlap.
TEST_CASE("the stiffness after an increment is the derivative of its forces") {
  const bool slides = GENERATE(true, false);
  const Values springs = {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e4}},
                          {"tangential_damping", {0}},
                          {"static_friction", {slides ? 0.1 : 1e3}}};
  const bool surfaces = GENERATE(true, false);
  for (const int dimension : {2, 3}) {
    INFO(dimension << " dimensions, surfaces: " << surfaces);
    Increment increment(surfaces ? moving_beds(dimension, "linear_spring_dashpot", springs)
                                 : moving_heap(dimension, "linear_spring_dashpot", springs));
    const DegreesOfFreedom& freedom = increment.freedom;
    Entries entries(freedom, WallEquations{});
    increment.evaluate(increment.motion);
    increment.contacts.add_stiffness(entries);
    const Eigen::MatrixXd stiffness = entries.of_motions();
    const auto forces_at = [&](const Eigen::VectorXd& motion) {
      increment.evaluate(motion);
      Eigen::VectorXd all(freedom.size());
      for (std::size_t i = 0; i < freedom.bodies(); ++i) {
        for (int k = 0; k < dimension; ++k) all[freedom.translation(i, k)] = increment.loads.force[i][k];
        for (int k = 0; k < increment.spins(); ++k)
          all[freedom.rotation(i, k)] = increment.loads.torque[i][dimension == 2 ? 2 : k];
      }
      return all;
    };
    constexpr double change = 1e-6;
    Eigen::MatrixXd difference(freedom.size(), freedom.size());
    for (Eigen::Index c = 0; c < freedom.size(); ++c) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(freedom.size(), c);
      difference.col(c) =
          (forces_at(increment.motion - change * unit) - forces_at(increment.motion + change * unit)) /
          (2 * change);
    }
    // Round-off of 1e3 N over the change: 1e-7 N/m; third derivatives: the square of the change over the
    // motion, 2e-2. In 3D the velocity by which laws turn the direction of slip counts with the normal at
    // rest: the motion over the radius.
    const double tolerance = dimension == 3 && slides ? share : 1e-6;
    CHECK((stiffness - difference).cwiseAbs().maxCoeff() < tolerance * difference.cwiseAbs().maxCoeff());
  }
}

}  // namespace scree::test
