// Uniform gravity, constant or a function of time.

#include <scree/plugin/body_force.hpp>
#include <scree/plugin/program.hpp>

namespace {

struct Gravity {
  std::array<double, 3> acceleration = {0, 0, 0};
  scree::Program components[3];
  scree::Vec3 g = {}, change = {};  // (m/s²) at the present time, and since the evaluation before

  static constexpr scree::About about = {
      "gravity", "uniform acceleration of every body",
      "f = m g(t), E = −m g·x\n"
      "work is done as g changes, dW = −m dg·x, by which E changes where bodies rest",
      "David et al. 2005, equation 5"};

  void declare(scree::Declaration& d) {
    static constexpr const char* keys[] = {"acceleration_x", "acceleration_y", "acceleration_z"};
    d.vector("acceleration", acceleration, "m/s^2", "g, for example [0, 0, -9.81]").required();
    for (int k = 0; k < 3; ++k)
      d.program(keys[k], components[k], "m/s^2", scree::any_number, "in place of this component of g")
          .optional();
  }

  void prepare(const scree::Setup& setup) {
    if (setup.dimension() == 2 && components[2].given())
      setup.refuse("a scene of two dimensions has no acceleration_z; remove it");
  }

  void at(double time, double before) {
    for (int k = 0; k < 3; ++k) {
      const bool given = components[k].given();
      g[k] = given ? components[k](time) : acceleration[std::size_t(k)];
      change[k] = given ? g[k] - components[k](before) : 0;
    }
  }

  void act(const scree::BodyState& body, scree::BodyForceOutput& out) const {
    out.force = body.mass * g;
    out.potential = -dot(out.force, body.position);
    out.work = -body.mass * dot(change, body.mid_position);
  }
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(Gravity)
