// Viscous drag on the translation and rotation of every body.

#include <scree/plugin/body_force.hpp>

namespace {

struct BackgroundDamping {
  double translational = 0;
  double rotational = 0;

  static constexpr scree::About about = {
      "background_damping", "viscous drag on translation and rotation",
      "f = −γ_b v\n"
      "t = −γ_br R² ω   (γ_br in kg/s as in David et al.; the factor R² gives a torque)",
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

  void act(const scree::BodyState& body, scree::BodyForceOutput& out) const {
    const double turning = rotational * body.radius * body.radius;
    out.force = -translational * body.velocity;
    out.torque = -turning * body.spin;
    out.dissipation_rate_translation = translational * dot(body.velocity, body.velocity);
    out.dissipation_rate_rotation = turning * dot(body.spin, body.spin);
  }
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(BackgroundDamping)
