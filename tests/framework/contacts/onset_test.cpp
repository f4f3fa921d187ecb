#include "contacts/onset.hpp"

#include "contacts/kernel/kinematics.hpp"

#include <algorithm>
#include <memory>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::kernel;

namespace {

constexpr double onset_step = 1e-4;

// Pairs that close at 1 m/s (or open, at −1), with overlaps of `depths` times the travel per step, and slide
// at 1 m/s, with forces that begin and end as t to these powers and act for `kick` (s).
std::unique_ptr<BlockColumns> pairs(const std::vector<double>& depths, double closing, double touching = 0,
                                    double parting = 0, double kick = onset_step) {
  auto w = std::make_unique<BlockColumns>();
  const std::vector<double> radius_sums(block_size, 1.0);
  for (std::uint32_t i = 0; i < block_size; ++i) {
    for (int k = 0; k < 3; ++k)
      w->input[SCREE_NORMAL + k][i] = w->separation[k][i] = w->velocity[k][i] = w->mid_velocity[k][i] = 0;
    w->input[SCREE_NORMAL][i] = w->separation[0][i] = w->distance[i] = 1;
    w->velocity[0][i] = -closing;
    w->mid_velocity[1][i] = 1;
    w->input[SCREE_OVERLAP][i] = i < depths.size() ? depths[i] * onset_step : -1;
  }
  if (resolve_motion<3, false, Partner::body, true>(true, radius_sums.data(), onset_step, kick, block_size,
                                                    *w) > 0)
    resolve_onsets<3, false, Partner::body, true>(true, radius_sums.data(), onset_step, kick,
                                                  OnsetWeights::of_power(touching),
                                                  OnsetWeights::of_power(parting), block_size, *w);
  else  // onset weights of a block without such pairs
    std::fill_n(w->input[SCREE_ONSET_WEIGHT], block_size, 1.0);
  return w;
}

// Fraction of the step during which a pair slid; sliding rotates the normal, by half a displacement, which
// reduces it by 2.5e-9.
double touched(const BlockColumns& w, std::uint32_t pair) {
  return w.input[SCREE_TANGENTIAL_INCREMENT + 1][pair] / onset_step;
}

}  // namespace

TEST_CASE("the onset weights of a dashpot add up to the contact time") {
  // Touch at a fraction of a step, then one step further each time. The sum of weights must be the number of
  // steps from the touch to half a step after the last evaluation.
  for (const double fraction : {0.01, 0.3, 0.5, 0.99}) {
    const auto w = pairs({fraction, fraction + 1, fraction + 2, fraction + 3, fraction + 4}, 1);
    double sum = 0;
    for (int n = 0; n < 5; ++n) sum += w->input[SCREE_ONSET_WEIGHT][n];
    CHECK(sum == Approx(fraction + 4 + 0.5));
    CHECK(touched(*w, 0) == Approx(fraction));
    CHECK(touched(*w, 1) == Approx(1));
  }
}

TEST_CASE("onset weights count in kicks, displacements in steps, without a kick there are no weights") {
  // The first step of position Verlet evaluates after half a kick.
  const auto w = pairs({0.5, 1.5, 3}, 1, 0, 0, 2 * onset_step), still = pairs({0.5}, 1, 0, 0, 0);
  CHECK(w->input[SCREE_ONSET_WEIGHT][0] == Approx(1.5 * 0.25));
  CHECK(w->input[SCREE_ONSET_WEIGHT][1] == Approx(1.5 * 0.75));
  CHECK(w->input[SCREE_ONSET_WEIGHT][2] == Approx(2 - 0.5 * 1.5));
  CHECK(touched(*w, 0) == Approx(0.5));
  CHECK(touched(*w, 1) == Approx(1));
  CHECK(still->input[SCREE_ONSET_WEIGHT][0] == 1);
  CHECK(touched(*still, 0) == Approx(0.5));
}

TEST_CASE("Hurwitz' zeta function: known values and the recurrence in its second argument") {
  // Riemann's zeta function at 0 and −1, its value at −1/2, and Bernoulli polynomials.
  CHECK(hurwitz_zeta(0, 1) == Approx(-0.5).epsilon(1e-14));
  CHECK(hurwitz_zeta(-1, 1) == Approx(-1.0 / 12).epsilon(1e-12));
  CHECK(hurwitz_zeta(-0.5, 1) == Approx(-0.2078862249773545).epsilon(1e-12));
  for (const double a : {0.01, 0.4, 1.0, 1.7}) {
    CHECK(hurwitz_zeta(0, a) == Approx(0.5 - a).margin(1e-13));
    CHECK(hurwitz_zeta(-1, a) == Approx(-(a * a - a + 1.0 / 6) / 2).margin(1e-12));
    for (const double z : {-0.25, -0.5, -0.75})
      CHECK(hurwitz_zeta(z, a) == Approx(std::pow(a, -z) + hurwitz_zeta(z, a + 1)).margin(1e-12));
  }
}

TEST_CASE("weighted samples of t^p add up to its integral wherever in a step first touch occurs") {
  for (const double power : {0.0, 0.25, 0.5, 0.75})
    for (const bool parts : {false, true})
      for (const double fraction : {0.001, 0.1, 0.37, 0.5, 0.8, 0.999}) {
        constexpr int samples = 40;
        std::vector<double> depths;
        for (int n = 0; n < samples; ++n) depths.push_back(fraction + n);
        const auto w = parts ? pairs(depths, -1, 1, power) : pairs(depths, 1, power, 1);
        double sum = 0;
        for (int n = 0; n < samples; ++n)
          sum += w->input[SCREE_ONSET_WEIGHT][n] * std::pow(fraction + n, power);
        // Integral up to half a step after the last sample; the midpoint rule ends with p/24 x^(p−1) there.
        const double end = fraction + samples - 0.5, integral = std::pow(end, power + 1) / (power + 1);
        INFO("power " << power << ", fraction " << fraction << (parts ? ", parting" : ", touching"));
        // The fit of the first weight, 1e-3 of its sample.
        CHECK(sum == Approx(integral - power / 24 * std::pow(end, power - 1)).margin(1.1e-3));
      }
}

TEST_CASE("weights are continuous, and 1 where the force is continuous") {
  const double near = 1e-9;
  for (const double power : {0.0, 0.25, 0.5, 0.75})
    for (const double s : {1.0, 2.0}) {
      const auto w = pairs({s - near, s + near}, 1, power);
      CHECK(w->input[SCREE_ONSET_WEIGHT][0] == Approx(w->input[SCREE_ONSET_WEIGHT][1]).margin(1.1e-3));
    }
  const auto smooth = pairs({0.01, 0.5, 1.5}, 1, 1);
  for (int k = 0; k < 3; ++k) CHECK(smooth->input[SCREE_ONSET_WEIGHT][k] == Approx(1).margin(1e-15));
}

TEST_CASE("parting pairs have touched during the whole step, and pairs in lasting contact have weight 1") {
  const auto parting = pairs({0.5, 3}, -1);
  CHECK(touched(*parting, 0) == Approx(1));
  CHECK(parting->input[SCREE_ONSET_WEIGHT][0] == Approx(0.75));
  CHECK(parting->input[SCREE_ONSET_WEIGHT][1] == 1);
  const auto resting = pairs({5, 7}, 1);
  for (std::uint32_t k = 0; k < 2; ++k) {
    CHECK(resting->input[SCREE_ONSET_WEIGHT][k] == 1);
    CHECK(touched(*resting, k) == Approx(1));
  }
}
