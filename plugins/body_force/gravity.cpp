// Uniform gravity.

#include <scree/plugin/body_force.hpp>

namespace {

struct Gravity {
  std::array<double, 3> acceleration = {0, 0, 0};

  static constexpr scree::About about = {"gravity", "uniform acceleration of every body",
                                         "f = m g, E = −m g·x", "David et al. 2005, equation 5"};

  void declare(scree::Declaration& d) {
    d.vector("acceleration", acceleration, "m/s^2", "g, for example [0, 0, -9.81]").required();
  }

  void act(const scree::BodyState& body, scree::BodyForceOutput& out) const {
    const scree::Vec3 g = {{acceleration[0], acceleration[1], acceleration[2]}};
    out.force = body.mass * g;
    out.potential = -dot(out.force, body.position);
  }
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(Gravity)
