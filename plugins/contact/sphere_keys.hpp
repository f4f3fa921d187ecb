// Keys of the law for spheres: those of `linear_spring_dashpot` or of `hertz_mindlin`, by its normal force.

#pragma once

#include "hertz_normal.hpp"
#include "linear_normal.hpp"
#include "linear_tangential.hpp"

#include <string>

namespace sphere {

enum class Normal { linear, hertz };

struct Keys : scree::ContactLaw {
  int normal_kind = 0;                   // Normal
  normal::Linear linear{.damping = -1};  // of normal = linear; below 0: not given
  tangential::Linear tangent{.stiffness = -1, .damping = -1, .static_friction = -1};  // likewise
  normal::Hertz hertz{.poissons_ratio = -1};  // of normal = hertz; -1: not given
  double friction = -1;                       // likewise; prepared: μ_s of both
  double restitution = 0;                     // 0: not given
  int tension = 0;                            // scree::Tension

  static constexpr int only_dimension = 3;

  Normal chosen_normal() const { return Normal(normal_kind); }
  // Whether the normal dashpot depends on the masses.
  bool damped_by_mass() const { return chosen_normal() == Normal::hertz || restitution > 0; }

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.choice("normal", normal_kind, "linear|hertz",
             "normal force and keys of linear_spring_dashpot, or of hertz_mindlin with history = potential");
    d.number("normal_stiffness", linear.stiffness, "N/m", positive, "linear, needed: k of the normal spring")
        .optional();
    d.number("normal_damping", linear.damping, "kg/s", non_negative, "linear: γ; or restitution").optional();
    d.number("tangential_stiffness", tangent.stiffness, "N/m", non_negative,
             "linear: k_t of the tangential spring")
        .optional();
    d.number("tangential_damping", tangent.damping, "kg/s", non_negative,
             "linear: γ_t of the tangential dashpot; 0 if absent")
        .optional();
    d.number("static_friction", tangent.static_friction, "", non_negative,
             "linear: μ_s; 0, or absent: frictionless, no tangential force")
        .optional();
    d.number("dynamic_friction", tangent.dynamic_friction, "", non_negative,
             "linear: μ_d <= μ_s; μ_s if absent")
        .optional();
    d.number("youngs_modulus", hertz.youngs_modulus, "Pa", positive, "hertz, needed: E of the bodies")
        .optional();
    d.number("poissons_ratio", hertz.poissons_ratio, "", normal::Hertz::poissons_range,
             "hertz, needed: ν of the bodies")
        .optional();
    d.number("other_youngs_modulus", hertz.other_youngs_modulus, "Pa", positive,
             "hertz: E of the second material, if different")
        .optional();
    d.number("other_poissons_ratio", hertz.other_poissons_ratio, "", normal::Hertz::poissons_range,
             "hertz: ν of the second material, if different")
        .optional();
    d.number("friction", friction, "", non_negative,
             "hertz: μ; 0, or absent: frictionless, no tangential force")
        .optional();
    d.number("restitution", restitution, "", positive_coefficient,
             "r or e; linear: or normal_damping; hertz: 1 if absent")
        .optional();
    d.choice(
        "tension", tension, "allowed|cut",
        "whether the force may become attractive at the end of a contact; the restitution is reached either way");
  }

  void prepare(const scree::Setup& setup) {
    std::string fault = foreign_key();
    if (fault.empty()) fault = chosen_normal() == Normal::linear ? prepare_linear() : prepare_hertz();
    if (!fault.empty()) setup.refuse(fault.c_str());
  }

  double onset_power() const { return chosen_normal() == Normal::hertz ? normal::Hertz::onset_power : 0; }
  double parting_power() const {
    return chosen_normal() == Normal::hertz ? hertz.parting_power() : linear.parting_power();
  }

 private:
  // Refusal of a key that is given for the other kind of normal force, or nothing.
  std::string foreign_key() const {
    const struct {
      const char* key;
      Normal of;
      bool given;
    } keys[] = {{"normal_stiffness", Normal::linear, linear.stiffness > 0},
                {"normal_damping", Normal::linear, linear.damping >= 0},
                {"tangential_stiffness", Normal::linear, tangent.stiffness >= 0},
                {"tangential_damping", Normal::linear, tangent.damping >= 0},
                {"static_friction", Normal::linear, tangent.static_friction >= 0},
                {"dynamic_friction", Normal::linear, tangent.dynamic_friction >= 0},
                {"youngs_modulus", Normal::hertz, hertz.youngs_modulus > 0},
                {"poissons_ratio", Normal::hertz, hertz.poissons_ratio > -1},
                {"other_youngs_modulus", Normal::hertz, hertz.other_youngs_modulus > 0},
                {"other_poissons_ratio", Normal::hertz, hertz.other_poissons_ratio > -1},
                {"friction", Normal::hertz, friction >= 0}};
    for (const auto& k : keys)
      if (k.given && k.of != chosen_normal()) {
        const std::string other = k.of == Normal::linear ? "linear" : "hertz";
        return std::string(k.key) + " belongs to normal = \"" + other + "\"; remove it, or set normal = \"" +
               other + "\"";
      }
    return "";
  }

  // Completes the parameters; returns why they are refused, with the cure, or nothing.
  std::string prepare_linear() {
    if (!(linear.stiffness > 0))
      return "normal = \"linear\" needs normal_stiffness; give it, or set normal = \"hertz\" with youngs_modulus "
             "and poissons_ratio";
    if ((linear.damping >= 0) == (restitution > 0))
      return "normal = \"linear\" needs either normal_damping or restitution; give one of them";
    linear.damping = std::max(linear.damping, 0.0);
    linear.restitution = restitution;
    linear.tension = tension;
    linear.prepare();
    tangent.stiffness = std::max(tangent.stiffness, 0.0);
    tangent.damping = std::max(tangent.damping, 0.0);
    tangent.static_friction = std::max(tangent.static_friction, 0.0);
    const char* const fault = tangent.prepare();
    friction = tangent.static_friction;
    return fault ? fault : "";
  }

  std::string prepare_hertz() {
    if (!(hertz.youngs_modulus > 0 && hertz.poissons_ratio > -1))
      return "normal = \"hertz\" needs youngs_modulus and poissons_ratio; give both";
    hertz.restitution = restitution > 0 ? restitution : 1;
    hertz.tension = tension;
    hertz.prepare();
    friction = std::max(friction, 0.0);
    tangent.dynamic_friction = friction;
    return "";
  }
};

}  // namespace sphere
