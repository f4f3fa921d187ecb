#include "coefficients.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace reference {

namespace {

using std::numbers::pi;

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

// e = exp(-ζ φ/√(1-ζ²)), φ = atan2(2ζ√(1-ζ²), 2ζ²-1): the force falls to zero before the overlap does. φ is
// twice the arc cosine of ζ, which also tells the continuation to ζ >= 1.
double restitution_of_cut(double ratio) {
  if (std::abs(ratio - 1) < 1e-9) return std::exp(-2.0);
  if (ratio > 1) return std::exp(-2 * ratio * std::acosh(ratio) / std::sqrt(ratio * ratio - 1));
  return std::exp(-2 * ratio * std::acos(ratio) / std::sqrt(1 - ratio * ratio));
}

}  // namespace

double damping_ratio(double restitution, Tension tension) {
  require(restitution > 0 && restitution <= 1, "restitution must be above 0 and at most 1");
  if (restitution == 1) return 0;
  const double logarithm = std::log(restitution);
  if (tension == Tension::allowed) return -logarithm / std::sqrt(pi * pi + logarithm * logarithm);
  double low = 0, high = 1 / restitution;
  for (int i = 0; i < 200 && high - low > 1e-17 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution_of_cut(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Coefficients::Coefficients(const Law& law, double effective_mass, double effective_radius)
    : law_(law), effective_mass_(effective_mass) {
  require(law.friction >= 0, "friction must not be negative");
  require(!law.dynamic_friction || (*law.dynamic_friction >= 0 && *law.dynamic_friction <= law.friction),
          "dynamic friction must not be negative or above the static one");
  if (law.restitution) damping_ratio_ = damping_ratio(*law.restitution, law.tension);
  if (!hertz()) {
    require(law.normal_stiffness > 0, "the normal stiffness must be positive");
    require(law.normal_damping >= 0 && law.tangential_damping >= 0, "damping must not be negative");
    require(law.tangential_stiffness > 0 || law.friction == 0, "friction needs a tangential stiffness");
    const double critical = 2 * std::sqrt(law.normal_stiffness * effective_mass);
    if (!law.restitution) damping_ratio_ = law.normal_damping / critical;
    elastic_ = law.normal_stiffness;
    normal_damping_ = law.restitution ? damping_ratio_ * critical : law.normal_damping;
    tangential_ = law.tangential_stiffness;
    tangential_damping_ = law.tangential_damping;
  } else {
    require(law.youngs_modulus > 0, "the Young modulus must be positive");
    require(law.history != History::potential || std::isfinite(law.friction),
            "without a Coulomb limit the potential history pushes without bound as the overlap vanishes");
    require(law.slip_rule == SlipRule::spring, "the slip rule total is one of the linear law alone");
    const double E_a = law.youngs_modulus, E_b = law.other_youngs_modulus.value_or(E_a);
    const double nu_a = law.poissons_ratio, nu_b = law.other_poissons_ratio.value_or(nu_a);
    // 1/E* = Σ(1-ν²)/E, 1/G* = Σ 2(2-ν)(1+ν)/E
    const double E = 1 / ((1 - nu_a * nu_a) / E_a + (1 - nu_b * nu_b) / E_b);
    const double G = 1 / (2 * (2 - nu_a) * (1 + nu_a) / E_a + 2 * (2 - nu_b) * (1 + nu_b) / E_b);
    const double fourth_root = std::sqrt(std::sqrt(effective_radius));
    elastic_ = 4.0 / 3 * E * std::sqrt(effective_radius);
    tangential_ = 8 * G * std::sqrt(effective_radius);
    normal_damping_ = 2 * damping_ratio_ * std::sqrt(5.0 / 3 * effective_mass * E) * fourth_root;
    tangential_damping_ = 4 * damping_ratio_ * std::sqrt(5.0 / 3 * effective_mass * G) * fourth_root;
  }
  require(law.tension == Tension::cut || damping_ratio_ < 1, "overdamped bodies that may pull never part");
}

double Coefficients::elastic_force(double overlap) const {
  return elastic_ * (hertz() ? overlap * std::sqrt(overlap) : overlap);
}

double Coefficients::elastic_force_slope(double overlap) const {
  return elastic_ * (hertz() ? 1.5 * std::sqrt(overlap) : 1);
}

double Coefficients::elastic_energy(double overlap) const {
  return elastic_ * overlap * overlap * (hertz() ? 0.4 * std::sqrt(overlap) : 0.5);
}

double Coefficients::normal_damping(double overlap) const {
  return normal_damping_ * (hertz() ? std::sqrt(std::sqrt(overlap)) : 1);
}

double Coefficients::normal_damping_slope(double overlap) const {
  return hertz() && overlap > 0 ? normal_damping(overlap) / (4 * overlap) : 0;
}

double Coefficients::tangential_stiffness(double overlap) const {
  return tangential_ * (hertz() ? std::sqrt(overlap) : 1);
}

double Coefficients::tangential_stiffness_slope(double overlap) const {
  return hertz() && overlap > 0 ? tangential_stiffness(overlap) / (2 * overlap) : 0;
}

double Coefficients::tangential_damping(double overlap) const {
  return tangential_damping_ * (hertz() ? std::sqrt(std::sqrt(overlap)) : 1);
}

double Coefficients::duration(double approach_speed) const {
  const double slowing = std::sqrt(std::max(1 - damping_ratio_ * damping_ratio_, 0.01));
  const double hastening = 1 + 2 * std::max(damping_ratio_ - 1, 0.0);
  if (!hertz()) return pi * std::sqrt(effective_mass_ / elastic_) / slowing * hastening;
  // ½ m v² = (2/5) elastic δ^(5/2)
  const double overlap = std::pow(1.25 * effective_mass_ * approach_speed * approach_speed / elastic_, 0.4);
  return 2.9432750 * overlap / approach_speed / slowing * hastening;
}

}  // namespace reference
