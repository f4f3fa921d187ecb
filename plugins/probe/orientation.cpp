// The orientation of selected bodies.

#include <scree/plugin/probe.hpp>

namespace {

struct OrientationProbe {
  scree::BodyList bodies;
  int dimension = 3;

  static constexpr scree::About about = {
      "orientation", "rotation of selected bodies since the start",
      "2D: angle_<id>, not reduced to one turn\n"
      "3D: w_<id>, x_<id>, y_<id>, z_<id>: unit quaternion, (cos(φ/2), sin(φ/2) e) for an angle φ about e",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies to record").required();
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_ORIENTATIONS;
    instance.column_count = std::uint32_t(bodies.size()) * components();
    instance.state_width = std::uint32_t(bodies.size());
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* components_3d[] = {"w_", "x_", "y_", "z_"};
    const char* component = dimension == 2 ? "angle_" : components_3d[c % 4];
    return {component + std::to_string(bodies.id(c / components())), dimension == 2 ? "rad" : "",
            dimension == 2 ? "since the start, not reduced to one turn"
                           : "component of the unit quaternion since the start"};
  }
  std::string start(const scree_view& view, double* state) const { return bodies.find(view, state); }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    bodies.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    for (std::uint64_t n = 0; n < bodies.size(); ++n) {
      const std::uint64_t i = bodies.index(view, state, n);
      for (std::uint32_t k = 0; k < components(); ++k) *row++ = view.orientation[k][i];
    }
  }

 private:
  std::uint32_t components() const { return dimension == 2 ? 1 : 4; }
};

}  // namespace

SCREE_PROBE_PLUGIN(OrientationProbe)
