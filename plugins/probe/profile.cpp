// The motion of bodies by their heights at the start.

#include <algorithm>
#include <limits>

#include <scree/plugin/layers.hpp>
#include <scree/plugin/walls.hpp>

namespace {

struct ProfileProbe {
  scree::Layers layers;
  double bins = 0;
  double low = std::numeric_limits<double>::quiet_NaN(), high = low;  // NaN: not given

  static constexpr scree::About about = {
      "profile", "mean motion of bodies in bins along an axis, by their heights at the start",
      "bin k: low + (k − 1) w ≤ y_i(0) < low + k w (the last: ≤), w = (high − low)/bins, for axis = \"y\"\n"
      "columns bodies_<k>, position_<k>, velocity_<k>, displacement_<k>, as in the probe layer",
      "Lemrich et al. 2017, figure 4"};

  void declare(scree::Declaration& d) {
    layers.declare(d);
    d.number("bins", bins, "", scree::Range{.minimum = 1, .maximum = 1000},
             "number of bins of equal height, each with a body at least")
        .required();
    d.number("low", low, "m", scree::any_number, "lower end; without it the wall there at the start")
        .optional();
    d.number("high", high, "m", scree::any_number, "upper end; without it the wall there at the start")
        .optional();
  }
  void prepare(const scree::Setup& setup) {
    layers.check(setup);
    if (bins != std::floor(bins)) setup.refuse("bins is no whole number; give one");
    layers.count = std::uint64_t(bins);
  }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(4 * layers.count);
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"bodies_", "position_", "velocity_", "displacement_"};
    static constexpr const char* units[] = {"", "m", "m/s", "m"};
    return {names[c % 4] + std::to_string(c / 4 + 1), units[c % 4], scree::Layers::meanings[c % 4]};
  }

  std::uint64_t state_size(const scree_view& view) const { return layers.state_size(view); }

  std::string start(const scree_view& view, double* state) const {
    const double from = end(view, low, 1), to = end(view, high, -1), period = view.period[layers.axis];
    if (std::isnan(to - from)) return no_wall();
    if (!(to > from)) return "high is not above low; exchange them";
    // Ends that are rounded may be longer than the period by round-off.
    if (period > 0 && to - from > period * (1 + 1e-12))
      return "from low to high is more than a period; give ends at most a period apart";
    const double width = (to - from) / bins;
    const auto bin_of = [&](std::uint64_t i) {
      double above = layers.height(view, i, from);
      if (above < 0) above += period;
      const bool inside = above >= 0 && above <= to - from;
      return inside ? std::min(layers.count - 1, std::uint64_t(above / width)) : layers.count;
    };
    const auto middle = [&](std::uint64_t n) { return from + (double(n) + 0.5) * width; };
    const auto filled = layers.gather(view, middle, bin_of, state);
    for (std::uint64_t n = 0; n < layers.count; ++n)
      if (filled[n].bodies == 0) return empty(n + 1, from + double(n) * width, from + double(n + 1) * width);
    return "";
  }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    layers.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    for (const scree::LayerMotion& bin : layers.motion(view, state)) {
      *row++ = bin.bodies;
      *row++ = bin.position();
      *row++ = bin.velocity;
      *row++ = bin.displacement;
    }
  }

 private:
  // The end that is given (m), or that of the wall; NaN without either.
  double end(const scree_view& view, double given, int sign) const {
    return std::isnan(given)
               ? scree::wall_height({view.planes, view.plane_count}, layers.axis, sign, view.plane_absent)
               : given;
  }
  std::string no_wall() const {
    return std::string("the axis ") + "xyz"[layers.axis] + " has no walls at its ends; give low and high";
  }
  std::string empty(std::uint64_t number, double from, double to) const {
    char problem[160];
    std::snprintf(
        problem, sizeof(problem),
        "bin %llu of %.0f, from %c = %.6g m to %.6g m, has no body; give fewer bins, or low and high "
        "within the bodies",
        static_cast<unsigned long long>(number), bins, "xyz"[layers.axis], from, to);
    return problem;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(ProfileProbe)
