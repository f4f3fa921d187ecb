// A body force: a spring to a point. Replace equations, parameters and forces by your own; the guide is
// share/doc/scree/plugins/README.md of scree.

#include <scree/plugin/body_force.hpp>

namespace {

struct PluginName {
  double stiffness = 0;
  std::array<double, 3> centre = {};

  static constexpr scree::About about = {"plugin_name", "spring from every body to a point",
                                         "f = −k (x − x_0)", "your source, with the number of the equation"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N/m", scree::non_negative, "k").required();
    d.vector("centre", centre, "m", "x_0").optional();
  }

  void act(const scree::BodyState& body, scree::BodyForceOutput& out) const {
    const scree::Vec3 arm = body.position - scree::Vec3{{centre[0], centre[1], centre[2]}};
    out.force = -stiffness * arm;
    out.potential = 0.5 * stiffness * dot(arm, arm);
  }
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(PluginName)
