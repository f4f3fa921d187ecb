// The motion of a layer of bodies, chosen by their heights at the start.

#include <scree/plugin/layer_height.hpp>
#include <scree/plugin/layers.hpp>

namespace {

struct LayerProbe {
  scree::Layers layers = {.count = 1};
  scree::LayerHeight at = {"at", "at_share"};
  double half_width = 0;

  static constexpr scree::About about = {
      "layer", "mean motion of the bodies that are in a layer at the start",
      "bodies: those with |y_i(0) − at| ≤ half_width, for axis = \"y\"\n"
      "position = ⟨y_i(t)⟩, velocity = ⟨v_i(t)⟩, displacement = ⟨y_i(t)⟩ − ⟨y_i(0)⟩\n"
      "y_i: path without jumps at periodic faces; 0: when the probe first records",
      "Lemrich et al. 2017, section 3"};

  void declare(scree::Declaration& d) {
    layers.declare(d);
    at.declare(d, "height of the middle of the layer",
               "the same as a share of the length between the walls, from the lower one");
    d.number("half_width", half_width, "m", scree::positive, "half the height of the layer").required();
  }
  void prepare(const scree::Setup& setup) { layers.check(setup); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = 4;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"bodies", "position", "velocity", "displacement"};
    static constexpr const char* units[] = {"", "m", "m/s", "m"};
    return {names[c], units[c], scree::Layers::meanings[c]};
  }

  std::uint64_t state_size(const scree_view& view) const { return layers.state_size(view); }

  std::string start(const scree_view& view, double* state) const {
    double height = 0;
    const std::string problem = at.find(view, layers.axis, height);
    return problem.empty() ? layers.start_around(view, &height, half_width, state) : problem;
  }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    layers.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    const scree::LayerMotion layer = layers.motion(view, state)[0];
    row[0] = layer.bodies;
    row[1] = layer.position();
    row[2] = layer.velocity;
    row[3] = layer.displacement;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(LayerProbe)
