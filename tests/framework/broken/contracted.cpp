// A plug-in compiled so that products and sums are fused: see CMakeLists.txt.
#include <scree/plugin/body_force.hpp>

namespace {

struct Contracted {
  static constexpr scree::About about = {"contracted", "compiled so that products and sums are fused",
                                         "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void act(const scree::BodyState&, scree::BodyForceOutput&) const {}
};

}  // namespace

SCREE_BODY_FORCE_PLUGIN(Contracted)
