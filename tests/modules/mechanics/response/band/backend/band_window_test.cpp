#include "band/band_library.hpp"
#include "matrices.hpp"

#include <atomic>
#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree::response;
using scree::test::Complex;
using scree::test::DenseComplex;
using scree::test::Sparse;

namespace {

constexpr int chain_size = 150, chain_frequencies = 20;

// A chain of masses of 1 between springs of 1 that differ by some per cent, with dashpots in proportion.
struct Chain {
  Sparse stiffness{chain_size, chain_size}, damping;
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(chain_size);

  explicit Chain(double dashpots, bool held = true) {
    for (int k = 0; k < chain_size; ++k) {
      const double spring = 1 + 0.05 * std::sin(3.1 * k);
      if (k > 0 || held) stiffness.coeffRef(k, k) += spring;
      if (k == 0) continue;
      stiffness.coeffRef(k - 1, k - 1) += spring;
      stiffness.coeffRef(k, k - 1) -= spring, stiffness.coeffRef(k - 1, k) -= spring;
    }
    stiffness.makeCompressed();
    damping = dashpots * stiffness;
  }
  DenseComplex at(double omega) const {
    return DenseComplex(stiffness) + Complex(0, omega) * DenseComplex(damping) -
           omega * omega * DenseComplex(mass.asDiagonal());
  }
};

struct Window {
  Eigen::VectorXd omega, residual, error;
  DenseComplex load, amplitude;
  int basis = 0;

  Window(const Chain& chain, Eigen::VectorXd frequencies, double tolerance, bool single,
         const std::atomic<bool>* stop = nullptr)
      : omega(std::move(frequencies)),
        residual(omega.size()),
        error(omega.size()),
        load(DenseComplex::Zero(chain_size, omega.size())),
        amplitude(chain_size, omega.size()) {
    for (Eigen::Index k = 0; k < omega.size(); ++k) load(0, k) = 1;
    load.col(omega.size() / 2) *= omega.size() > 2 ? 0 : 1;  // one frequency without a load
    const auto backend =
        band_library().create(view_of(chain.stiffness), view_of(chain.damping), chain.mass.data());
    basis = backend->solve({int(omega.size()), omega.data(), load.data(), tolerance, single, amplitude.data(),
                            residual.data(), error.data(), stop});
  }
};

}  // namespace

// The stated errors, and those against dense solutions, whose round-off is 1e-13.
TEST_CASE("neighbouring frequencies have the amplitudes of dense solutions within their stated errors",
          "[response]") {
  const Chain chain(0.05);
  for (const auto& [tolerance, single] : {std::pair{1e-9, false}, {1e-3, true}, {1e-3, false}}) {
    CAPTURE(tolerance, single);
    const Window window(chain, Eigen::VectorXd::LinSpaced(chain_frequencies, 0.98, 1.02), tolerance, single);
    CHECK(window.basis > 0);
    CHECK(window.basis < chain_size);
    int found = 0;
    for (Eigen::Index k = 0; k < chain_frequencies; ++k) {
      if (k == chain_frequencies / 2) {
        CHECK(window.amplitude.col(k).norm() == 0);
        CHECK(window.error[k] == 0);
        continue;
      }
      const Eigen::VectorXcd exact = chain.at(window.omega[k]).partialPivLu().solve(window.load.col(k));
      const double error = (window.amplitude.col(k) - exact).norm() / exact.norm();
      CHECK(error < window.error[k] + 1e-12);
      found += window.error[k] <= tolerance;
      const double residual =
          (window.load.col(k) - chain.at(window.omega[k]) * window.amplitude.col(k)).norm();
      CHECK(window.residual[k] == Approx(residual).margin(1e-12));
    }
    CHECK(found > chain_frequencies / 2);  // the others are left to narrower windows
  }
}

TEST_CASE("a frequency at which the matrix is singular has no error", "[response]") {
  // Nothing holds the chain, so that a constant force at 0 moves it without end.
  const Chain loose(0.05, false);
  CHECK(std::isnan(Window(loose, Eigen::VectorXd::Zero(1), 1e-9, false).error[0]));
  CHECK(Window(Chain(0.05), Eigen::VectorXd::Zero(1), 1e-9, false).error[0] < 1e-9);
}

TEST_CASE("a window that is stopped before it begins has no basis", "[response]") {
  const std::atomic<bool> stop = true;
  const Window window(Chain(0.05), Eigen::VectorXd::LinSpaced(chain_frequencies, 0.98, 1.02), 1e-9, false,
                      &stop);
  CHECK(window.basis == 0);
}
