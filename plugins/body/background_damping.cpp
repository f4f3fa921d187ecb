// Viscous drag on every body by itself, in translation and in rotation.

#include <scree/body_term.hpp>

namespace {

struct BackgroundDamping {
  double translational = 0;
  double rotational = 0;

  static constexpr scree::About about = {
      "background_damping", "viscous drag on translation and rotation",
      "f = −γ_b v\n"
      "t = −γ_br R² ω   (γ_br in kg/s as printed by David et al.; scaled by R² it makes a torque)",
      "David et al. 2005, section 2; Lemrich et al. 2017 (γ_a)"};

  void declare(scree::Declaration& d) {
    d.number("translational", translational, "kg/s", scree::non_negative, "γ_b");
    d.number("rotational", rotational, "kg/s", scree::non_negative,
             "γ_br; no effect in a scene without spin");
  }

  double damping_rate(double mass, double inertia, double radius) const {
    const double turning = inertia > 0 ? rotational * radius * radius / inertia : 0;
    return turning > translational / mass ? turning : translational / mass;
  }

  void apply(scree_body_batch& batch) const {
    for (int k = 0; k < 3; ++k)
      if (batch.velocity[k])
        batch.dissipated_translation += drag(batch.velocity[k], batch.force[k], batch.count,
                                             [this](std::uint32_t) { return translational; });
    for (int k = 0; k < 3; ++k)
      if (batch.spin[k])
        batch.dissipated_rotation += drag(batch.spin[k], batch.torque[k], batch.count, [&](std::uint32_t i) {
          return rotational * batch.radius[i] * batch.radius[i];
        });
  }

 private:
  // Adds −coefficient × rate to the load; returns the power lost.
  template <class Coefficient>
  static double drag(const double* rate, double* load, std::uint32_t count, const Coefficient& coefficient) {
    // Eight interleaved sums, so that the loop runs on vector registers with the same bits on all.
    constexpr std::uint32_t parts = 8;
    double lost[parts] = {};
    const auto slow = [&](std::uint32_t i, std::uint32_t part) {
      const double resistance = coefficient(i) * rate[i];
      load[i] -= resistance;
      lost[part] += resistance * rate[i];
    };
    const std::uint32_t whole = count / parts * parts;
    for (std::uint32_t i = 0; i < whole; i += parts)
      for (std::uint32_t k = 0; k < parts; ++k) slow(i + k, k);
    for (std::uint32_t i = whole; i < count; ++i) slow(i, 0);
    for (std::uint32_t k = 1; k < parts; ++k) lost[0] += lost[k];
    return lost[0];
  }
};

}  // namespace

SCREE_BODY_TERM_PLUGIN(BackgroundDamping)
