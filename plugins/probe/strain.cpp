// The local strain between two layers of bodies.

#include <algorithm>

#include <scree/plugin/layer_height.hpp>
#include <scree/plugin/layers.hpp>

namespace {

struct StrainProbe {
  scree::Layers layers = {.count = 2};
  scree::LayerHeight low = {"low", "low_share"}, high = {"high", "high_share"};
  double half_width = 0;

  static constexpr scree::About about = {
      "strain", "local strain between two layers of bodies, above 0 in extension",
      "ε(t) = (d(t) − d(0))/d(0), ε'(t) = d'(t)/d(0), distance = d(t)\n"
      "d = ⟨y_high⟩ − ⟨y_low⟩: distance of the mean heights of the bodies that are in the layers at the start\n"
      "about the mean of a time, as in equation 8: d/⟨d⟩ − 1 = (ε − ⟨ε⟩)/(1 + ⟨ε⟩)",
      "Lemrich et al. 2017, equation 8, which takes the mean ⟨d⟩ over 60 periods in place of d(0)"};

  void declare(scree::Declaration& d) {
    layers.declare(d);
    low.declare(d, "height of the middle of the lower layer",
                "the same as a share of the length between the walls, from the lower one");
    high.declare(d, "height of the middle of the upper layer",
                 "the same as a share of the length between the walls, from the lower one");
    d.number("half_width", half_width, "m", scree::positive, "half the height of each layer").required();
  }
  void prepare(const scree::Setup& setup) { layers.check(setup); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = 5;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"strain", "strain_rate", "distance", "bodies_low", "bodies_high"};
    static constexpr const char* units[] = {"", "1/s", "m", "", ""};
    static constexpr const char* meanings[] = {"distance / distance at the start − 1, above 0 in extension",
                                               "its rate", "between the mean heights of the two layers",
                                               "number in the lower layer", "number in the upper layer"};
    return {names[c], units[c], meanings[c]};
  }

  std::uint64_t state_size(const scree_view& view) const { return layers.state_size(view); }

  std::string start(const scree_view& view, double* state) const {
    double heights[2] = {};
    if (const std::string problem = low.find(view, layers.axis, heights[0]); !problem.empty()) return problem;
    if (const std::string problem = high.find(view, layers.axis, heights[1]); !problem.empty())
      return problem;
    const double apart = heights[1] - heights[0], period = view.period[layers.axis];
    if (!((period > 0 ? std::min(apart, period - apart) : apart) > 2 * half_width)) return overlap(heights);
    return layers.start_around(view, heights, half_width, state);
  }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    layers.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    const std::vector<scree::LayerMotion> motion = layers.motion(view, state);
    const scree::LayerMotion &below = motion[0], &above = motion[1];
    const double start = above.start - below.start, change = above.displacement - below.displacement;
    row[0] = change / start;
    row[1] = (above.velocity - below.velocity) / start;
    row[2] = start + change;
    row[3] = below.bodies;
    row[4] = above.bodies;
  }

 private:
  std::string overlap(const double (&heights)[2]) const {
    char problem[200];
    std::snprintf(problem, sizeof(problem),
                  "the layers at %c = %.6g m and %.6g m overlap or are in reverse order; give a high that is "
                  "more than 2 half_width = %.6g m above low, or a smaller half_width",
                  "xyz"[layers.axis], heights[0], heights[1], 2 * half_width);
    return problem;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(StrainProbe)
