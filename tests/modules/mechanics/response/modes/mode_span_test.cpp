#include "modes/mode_span.hpp"

#include "band/backend/band_backend.hpp"
#include "packings.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

// Dense eigenvalues of the symmetric part: round-off of 1e-12, and a tolerance of the iteration of 1e-11.
TEST_CASE("modes are found next to a shift, and further ones across those that are found", "[response]") {
  const test::Values springs = {{"normal_stiffness", {1000}},
                                {"normal_damping", {0}},
                                {"tangential_stiffness", {600}},
                                {"static_friction", {50}}};
  const LinearSystem system =
      assemble(Simulation(test::heap(3, springs, "linear_spring_dashpot", 1)), {.fewest_contacts = 1});
  const UndampedSystem undamped(system);
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(undamped.symmetric_stiffness()))
          .eigenvalues();
  const ModeSearch search;
  ModeSpan span(undamped, search);
  const auto below = undamped.factorise(squares[0] - 1);
  for (const Eigen::Index wanted : {3, 4}) {
    const Eigen::Index before = span.size();
    span.find(*below, wanted, true);
    REQUIRE(span.size() >= before + wanted);
  }
  std::vector<double> found = span.squares();
  std::sort(found.begin(), found.end());
  for (std::size_t k = 0; k < 7; ++k)
    CHECK(found[k] == Approx(squares[Eigen::Index(k)]).margin(1e-9 * undamped.largest()).epsilon(0));
  const Eigen::MatrixXd& modes = span.modes();
  CHECK((modes.transpose() * modes - Eigen::MatrixXd::Identity(span.size(), span.size())).norm() < 1e-12);
  const Eigen::MatrixXd some = Eigen::MatrixXd::Identity(modes.rows(), 5);
  CHECK((modes.transpose() * span.across(some)).norm() < 1e-13);
  CHECK(span.heavy_part(some) == some);  // every degree of freedom has a mass
}
