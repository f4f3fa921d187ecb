// A boundary: a floor that rises with constant velocity. Replace walls, parameters and motion by your own;
// the guide is share/doc/scree/plugins/README.md of scree.

#include <scree/plugin/boundary.hpp>

namespace {

struct PluginName {
  double height = 0, velocity = 0;
  int up = 2;  // the last axis of the scene

  static constexpr scree::About about = {"plugin_name", "a floor that rises with constant velocity",
                                         "z_w(t) = height + u t",
                                         "your source, with the number of the equation"};

  void declare(scree::Declaration& d) {
    d.number("height", height, "m", scree::any_number, "z_w at the start");
    d.number("velocity", velocity, "m/s", scree::any_number, "u");
  }
  void prepare(const scree::Setup& setup) { up = setup.dimension() - 1; }

  void describe(scree::BoundaryLayout& layout) const { layout.walls = 1; }

  // Null, or the problem and a remedy.
  const char* start(const scree::BoundaryStep& s) const {
    s.walls[0] = {};
    s.walls[0].point[up] = height;
    s.walls[0].normal[up] = 1;
    s.walls[0].velocity[up] = velocity;
    return nullptr;
  }
  // The wall from t to t + step; half of the work that it does, with the load at t.
  void begin_step(const scree::BoundaryStep& s) const {
    s.walls[0].point[up] += velocity * s.step;
    s.walls[0].mid_velocity[up] = s.walls[0].velocity[up] = velocity;
    s.energy.work -= 0.5 * s.loads[0].force[up] * velocity * s.step;
  }
  // The other half, with the load at t + step.
  void finish_step(const scree::BoundaryStep& s) const {
    s.energy.work -= 0.5 * s.loads[0].force[up] * velocity * s.step;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(PluginName)
