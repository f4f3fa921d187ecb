// One infinite plane, fixed or with prescribed motion.

#include <cmath>

#include <scree/plugin/boundary.hpp>

namespace {

struct Plane {
  std::array<double, 3> point = {};
  std::array<double, 3> normal = {};
  std::array<double, 3> direction = {};
  scree::Program displacement;

  // Layout of the state: the load of the last step (N).
  enum State { load_x, load_y, load_z, state_width };

  static constexpr scree::About about = {
      "plane", "infinite plane, fixed or with prescribed motion",
      "x_w(t) = point + e (s(t) − s(0))   e: direction of motion, s: displacement", "—"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "any point of the plane").required();
    d.vector("normal", normal, "", "normal pointing to the bodies; need not be a unit vector").required();
    d.vector("direction", direction, "", "direction of motion; the normal if absent").optional();
    d.program("displacement", displacement, "m", scree::any_number,
              "s(t) along the direction; fixed if absent")
        .optional();
  }

  void prepare(const scree::Setup& setup) {
    if (!make_unit(normal)) return setup.refuse("normal has length 0; give a vector such as [0, 0, 1]");
    if (!make_unit(direction)) direction = normal;
  }

  void describe(scree_boundary_instance& instance) const {
    instance.plane_count = 1;
    instance.state_width = state_width;
    instance.still = !moves();
  }

  void start(const scree_boundary_step& s) const {
    scree_plane& plane = s.planes[0];
    for (int k = 0; k < 3; ++k) {
      plane.point[k] = point[k];
      plane.normal[k] = normal[k];
      plane.velocity[k] = plane.mid_velocity[k] = moves() ? displacement.rate(0) * direction[k] : 0;
    }
  }

  void begin_step(const scree_boundary_step& s) const {
    scree_plane& plane = s.planes[0];
    const double distance = moves() ? displacement(s.time + s.step) - displacement(s.time) : 0;
    const double speed = moves() ? displacement.rate(s.time + s.step) : 0;
    for (int k = 0; k < 3; ++k) {
      plane.point[k] += distance * direction[k];
      plane.mid_velocity[k] = distance / s.step * direction[k];
      plane.velocity[k] = speed * direction[k];
    }
  }

  void finish_step(const scree_boundary_step& s) const {
    for (int k = 0; k < 3; ++k) {
      const double force = s.loads[0].force[k];
      s.energy->work -= 0.5 * (s.state[load_x + k] + force) * s.planes[0].mid_velocity[k] * s.step;
      s.state[load_x + k] = force;
    }
  }

 private:
  bool moves() const { return displacement.given(); }
  static bool make_unit(std::array<double, 3>& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (double& x : v) x /= length > 0 ? length : 1;
    return length > 0;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Plane)
