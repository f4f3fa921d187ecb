// A plug-in compiled with -ffast-math: see CMakeLists.txt.
#include <scree/plugin/body_force.hpp>

namespace {

struct FastMath {
  static constexpr scree::About about = {"fast_math", "compiled with -ffast-math", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void act(const scree::BodyState&, scree::BodyForceOutput&) const {}
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(FastMath)
