// A plug-in whose interface struct has another size.
#include <scree/plugin/body_force.hpp>

namespace {

struct OtherSize {
  static constexpr scree::About about = {"other_size", "has another interface", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void act(const scree::BodyState&, scree::BodyForceOutput&) const {}
};

const scree_body_force body_force = {sizeof(scree_body_force) + 8, sizeof(OtherSize),
                                     &scree::configure_author<OtherSize>,
                                     &scree::detail::apply_body_force<OtherSize>, nullptr};

}  // namespace

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) {
  return scree::manifest_of<OtherSize>(SCREE_BODY_FORCE, body_force);
}
