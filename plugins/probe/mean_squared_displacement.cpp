// How far bodies move from where they were.

#include <algorithm>

#include <scree/plugin/probe.hpp>

namespace {

struct MeanSquaredDisplacementProbe {
  scree::BodyList bodies;
  double window = 0;
  int dimension = 3;

  static constexpr scree::About about = {
      "mean_squared_displacement", "mean squared displacement of bodies, since the start or over windows",
      "total = ⟨|x(t) − x(t_0)|²⟩, x, y, z: parts along the axes    x: path without jumps at periodic faces\n"
      "with a window: mean over all windows that are complete, one after the other; NaN before the first",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies; without it all").optional();
    d.number("window", window, "s", scree::positive,
             "length t − t_0, a multiple of observe_every if that is given; without it t_0 is the start")
        .optional();
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(dimension) + 1;
    instance.observes = window > 0;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"total", "x", "y", "z"};
    return {names[c], "m^2", c == 0 ? "sum over the axes" : "part along the axis"};
  }

  // State: t_0; number of complete windows; sums over them along x, y, z; positions at t_0; indices of a
  // list.
  std::uint64_t count(const scree_view& view) const {
    return bodies.size() ? bodies.size() : view.body_count;
  }
  std::uint64_t state_size(const scree_view& view) const { return 5 + 3 * count(view) + bodies.size(); }

  std::string start(const scree_view& view, double* state) const {
    const std::string missing = bodies.find(view, state + 5 + 3 * count(view));
    if (!missing.empty()) return missing;
    for (std::uint64_t k = 0; k < bodies.size(); ++k)
      if (!scree::counts(view, bodies.index(view, state + 5 + 3 * count(view), k)))
        return "body " + std::to_string(bodies.id(k)) +
               " of ids is one that groups and leave_out do not count; remove its id";
    begin_window(view, state);
    return bodies.repeated();
  }

  void observe(const scree_view& view, double* state) const {
    const double late = view.time - state[0] - std::max(window, view.step_length);
    if (late < -0.5 * view.step_length) return;
    // Not a window: nothing was observed at its end, as in stages in which the probe does not record.
    if (late > 0.75 * view.step_length) return begin_window(view, state);
    const scree::Vec3 squares = mean_squares(view, state);
    for (int k = 0; k < 3; ++k) state[2 + k] += squares[k];
    state[1] += 1;
    begin_window(view, state);
  }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    for (std::uint64_t n = 0; n < count(view); ++n) marks[body(view, state, n)] = 1;
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    const scree::Vec3 sums = {{state[2], state[3], state[4]}};
    const scree::Vec3 mean = window > 0 ? 1 / state[1] * sums : mean_squares(view, state);
    row[0] = mean[0] + mean[1] + mean[2];
    for (int k = 0; k < dimension; ++k) row[1 + k] = mean[k];
  }

 private:
  std::uint64_t body(const scree_view& view, const double* state, std::uint64_t n) const {
    return bodies.size() ? bodies.index(view, state + 5 + 3 * count(view), n) : n;
  }
  scree::Vec3 position(const scree_view& view, const double* state, std::uint64_t n) const {
    return scree::unwrapped_position(view, body(view, state, n));
  }
  void begin_window(const scree_view& view, double* state) const {
    state[0] = view.time;
    for (std::uint64_t n = 0; n < count(view); ++n)
      std::copy_n(position(view, state, n).component, 3, state + 5 + 3 * n);
  }
  scree::Vec3 mean_squares(const scree_view& view, const double* state) const {
    scree::Vec3 sum = {};
    double counted = 0;
    for (std::uint64_t n = 0; n < count(view); ++n) {
      if (!scree::counts(view, body(view, state, n))) continue;
      ++counted;
      const double* const first = state + 5 + 3 * n;
      const scree::Vec3 moved = position(view, state, n) - scree::Vec3{{first[0], first[1], first[2]}};
      for (int k = 0; k < 3; ++k) sum[k] += moved[k] * moved[k];
    }
    return 1 / counted * sum;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(MeanSquaredDisplacementProbe)
