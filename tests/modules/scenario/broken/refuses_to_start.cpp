// A boundary that accepts its parameters, but not the scene.
#include <scree/plugin/boundary.hpp>

namespace {

struct RefusesToStart {
  static constexpr scree::About about = {"refuses_to_start", "for tests", "—", "—"};
  void declare(scree::Declaration&) {}
  void describe(scree::BoundaryLayout&) const {}
  const char* start(const scree::BoundaryStep& s) const {
    return s.scene().walls.empty() ? "there is no wall to lean on; add one before it" : nullptr;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(RefusesToStart)
