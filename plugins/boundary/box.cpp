// Rectangular box of 4 (2D) or 6 (3D) walls, each fixed or stress-controlled, after David et al. 2005.

#include <scree/plugin/boundary.hpp>

namespace {

struct Box {
  static constexpr int max_walls = 6;
  enum Control { stress_controlled, fixed };
  enum State { pressing_force, per_wall };  // of each wall at the last finish_step: p A (N)

  std::array<double, 3> lower = {}, upper = {};
  double gap = 0;
  double mass = 1;
  double viscosity = 0;
  int control[max_walls] = {};
  scree::Program stress;
  scree::Program axis_stress[3];
  scree::Program wall_stress[max_walls];
  int dimension = 3;
  double masses[max_walls] = {};  // (kg); 0 for fixed walls

  static constexpr scree::About about = {
      "box", "4 or 6 walls, each fixed or stress-controlled with mass and viscosity",
      "m_w s\" = F·n + p(t) A(t) − γ_w s'    s: inward displacement of the wall, n: inward normal,\n"
      "F: contact force on the wall, A(t): its present area (2D: length × 1 m)",
      "David et al. 2005, section 2; McNamara et al. 2008, equation 1"};

  static constexpr const char* names[max_walls] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
  static constexpr const char* stress_keys[max_walls] = {"stress_x_low",  "stress_x_high", "stress_y_low",
                                                         "stress_y_high", "stress_z_low",  "stress_z_high"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.vector("lower", lower, "m",
             "lower corner; without both corners that of the bodies' bounding box minus the gap")
        .optional();
    d.vector("upper", upper, "m",
             "upper corner; without both corners that of the bodies' bounding box plus the gap")
        .optional();
    d.number("gap", gap, "m", non_negative, "distance from the bodies if the corners are not given");
    d.number("mass", mass, "kg", positive, "m_w of each stress-controlled wall");
    d.number("viscosity", viscosity, "kg/s", non_negative, "γ_w of each stress-controlled wall");
    for (int w = 0; w < max_walls; ++w)
      d.choice(names[w], control[w], "stress|fixed", "stress-controlled or fixed");
    d.program("stress", stress, "Pa", any_number, "p of every wall, pressing inwards").optional();
    static constexpr const char* axis_keys[3] = {"stress_x", "stress_y", "stress_z"};
    for (int k = 0; k < 3; ++k)
      d.program(axis_keys[k], axis_stress[k], "Pa", any_number,
                "p of both walls of this axis; overrides stress")
          .optional();
    for (int w = 0; w < max_walls; ++w)
      d.program(stress_keys[w], wall_stress[w], "Pa", any_number,
                "p of this wall; overrides that of its axis")
          .optional();
  }

  void prepare(const scree::Setup& setup) {
    dimension = setup.dimension();
    const bool corners_given = lower != upper;
    for (int k = 0; k < dimension; ++k) {
      if (!corners_given) {
        lower[k] = setup.lower(k) - gap;
        upper[k] = setup.upper(k) + gap;
      }
      if (!(upper[k] > lower[k]))
        return setup.refuse("upper is not above lower; give both corners, or bodies to be enclosed");
    }
    for (int w = 0; w < walls(); ++w) {
      masses[w] = moving(w) ? mass : 0;
      if (!wall_stress[w].given()) wall_stress[w] = axis_stress[w / 2].given() ? axis_stress[w / 2] : stress;
      if (control[w] == stress_controlled && !wall_stress[w].given())
        return setup.refuse(
            "a stress-controlled wall has no stress; give stress = <Pa>, or set the wall to \"fixed\"");
    }
  }

  void describe(scree_boundary_instance& instance) const {
    instance.plane_count = std::uint32_t(walls());
    instance.state_width = std::uint32_t(walls() * per_wall);
    instance.plane_names = names;
    instance.plane_masses = masses;
    instance.still = 1;
    for (int w = 0; w < walls(); ++w)
      if (moving(w)) instance.damping_rate = viscosity / mass, instance.still = 0;
  }

  void start(const scree_boundary_step& s) const {
    for (int w = 0; w < walls(); ++w) {
      scree_plane& plane = s.planes[w];
      plane = {};
      for (int k = 0; k < dimension; ++k) plane.point[k] = w % 2 ? upper[k] : lower[k];
      plane.normal[w / 2] = sign(w);
    }
  }

  void begin_step(const scree_boundary_step& s) const {
    double push[max_walls];
    for (int w = 0; w < walls(); ++w) push[w] = push_on(w, s, s.time);
    for (int w = 0; w < walls(); ++w) {
      scree_plane& plane = s.planes[w];
      const int k = w / 2;
      const double speed = moving(w) ? plane.velocity[k] : 0;
      const double force = s.loads[w].force[k] + sign(w) * push[w] - viscosity * speed;
      const double change = moving(w) ? s.step * force / mass : 0;
      plane.mid_velocity[k] = speed + 0.5 * change;
      plane.velocity[k] = speed + change;
      plane.point[k] += s.step * plane.mid_velocity[k];
    }
  }

  void finish_step(const scree_boundary_step& s) const {
    s.energy->kinetic = 0;
    for (int w = 0; w < walls(); ++w) {
      scree_plane& plane = s.planes[w];
      const int k = w / 2;
      const double push = push_on(w, s, s.time + s.step);
      if (moving(w)) {
        // Implicit in the viscosity.
        const double force = s.loads[w].force[k] + sign(w) * push;
        const double mid = plane.mid_velocity[k];
        plane.velocity[k] = (mid + 0.5 * s.step * force / mass) / (1 + 0.5 * s.step * viscosity / mass);
        s.energy->kinetic += 0.5 * mass * plane.velocity[k] * plane.velocity[k];
        s.energy->work += 0.5 * (s.state[w * per_wall + pressing_force] + push) * sign(w) * mid * s.step;
        s.energy->dissipated += viscosity * mid * mid * s.step;
      } else {
        plane.velocity[k] = plane.mid_velocity[k] = 0;
      }
      s.state[w * per_wall + pressing_force] = push;
    }
  }

 private:
  int walls() const { return 2 * dimension; }
  bool moving(int w) const { return control[w] == stress_controlled; }
  static double sign(int w) { return w % 2 ? -1 : 1; }
  double area(int w, const scree_boundary_step& s) const {
    double a = 1;
    for (int k = 0; k < dimension; ++k)
      if (k != w / 2) a *= s.planes[2 * k + 1].point[k] - s.planes[2 * k].point[k];
    return a;
  }
  double push_on(int w, const scree_boundary_step& s, double time) const {
    return moving(w) ? wall_stress[w](time) * area(w, s) : 0;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Box)
