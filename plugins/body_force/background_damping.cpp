// Viscous drag on the translation and rotation of every body.

#include <scree/plugin/body_force.hpp>
#include <scree/plugin/program.hpp>

namespace {

struct BackgroundDamping {
  scree::Program translational_of, rotational_of;
  double translational = 0, rotational = 0;  // at the present time

  static constexpr scree::About about = {
      "background_damping", "viscous drag on translation and rotation",
      "f = −γ_b v\n"
      "t = −γ_br R² ω   (γ_br in kg/s as in David et al.; the factor R² gives a torque)",
      "David et al. 2005, section 2; Lemrich et al. 2017 (γ_a)"};

  void declare(scree::Declaration& d) {
    d.program("translational", translational_of, "kg/s", scree::non_negative, "γ_b; 0 if not given")
        .optional();
    d.program("rotational", rotational_of, "kg/s", scree::non_negative,
              "γ_br; 0 if not given; no effect in a scene without spin")
        .optional();
  }

  void at(double time) {
    translational = translational_of.given() ? translational_of(time) : 0;
    rotational = rotational_of.given() ? rotational_of(time) : 0;
  }

  double damping_rate(double mass, double inertia, double radius) const {
    const double moving = largest(translational_of) / mass;
    const double turning = inertia > 0 ? largest(rotational_of) * radius * radius / inertia : 0;
    return turning > moving ? turning : moving;
  }

  void act(const scree::BodyState& body, scree::BodyForceOutput& out) const {
    const double turning = rotational * body.radius * body.radius;
    out.force = -translational * body.velocity;
    out.torque = -turning * body.spin;
    out.dissipation_rate_translation = translational * dot(body.velocity, body.velocity);
    out.dissipation_rate_rotation = turning * dot(body.spin, body.spin);
  }

 private:
  static double largest(const scree::Program& program) {
    return program.given() ? program.extremes().second : 0;
  }
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(BackgroundDamping)
