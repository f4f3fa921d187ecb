// Total momentum and angular momentum of the bodies.

#include <algorithm>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/vec.hpp>

namespace {

using scree::Vec3;
using scree::vector_of;

struct MomentumProbe {
  std::array<double, 3> about_point = {};
  int dimension = 3;

  static constexpr scree::About about = {
      "momentum", "total momentum and angular momentum of the bodies",
      "p = Σ m v,   L = Σ m (x − x_0) × v + I ω     x_0: about;  I: moment of inertia\n"
      "Walls are not counted. Across a periodic axis p is conserved, but L is not.",
      "—"};

  void declare(scree::Declaration& d) {
    d.vector("about", about_point, "m", "x_0, reference point of the angular momentum");
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = instance.total_count = dimension == 2 ? 3 : 6;
    instance.leaves_out = 1;
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* flat[] = {"momentum_x", "momentum_y", "angular_momentum_z"};
    static constexpr const char* spatial[] = {"momentum_x",         "momentum_y",
                                              "momentum_z",         "angular_momentum_x",
                                              "angular_momentum_y", "angular_momentum_z"};
    const std::uint32_t axes = std::uint32_t(dimension);
    const bool linear = c < axes;
    return {dimension == 2 ? flat[c] : spatial[c], linear ? "kg m/s" : "kg m^2/s",
            linear ? "of all bodies" : "of all bodies, with respect to the point about"};
  }

  void accumulate(const scree_view& part, std::uint32_t, double* totals) const {
    Vec3 linear = {}, angular = {};
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!scree::counts(part, i)) continue;
      Vec3 arm = vector_of(part.position, i);
      for (int k = 0; k < dimension; ++k) arm[k] -= about_point[std::size_t(k)];
      const Vec3 p = part.mass[i] * vector_of(part.velocity, i);
      linear += p;
      angular += cross(arm, p);
      if (part.inertia) angular += part.inertia[i] * vector_of(part.spin, i);
    }
    for (int k = 0; k < dimension; ++k) *totals++ += linear[k];
    for (int k = dimension == 2 ? 2 : 0; k < 3; ++k) *totals++ += angular[k];
  }
  void sample(const scree_view& view, const double*, double* row) const {
    std::copy_n(view.totals, dimension == 2 ? 3 : 6, row);
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(MomentumProbe)
