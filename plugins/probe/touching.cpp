// Which bodies touch others: rattlers and the times of their collisions.

#include <algorithm>
#include <vector>

#include <scree/plugin/probe.hpp>

namespace {

struct TouchingProbe {
  scree::BodyList bodies;

  static constexpr scree::About about = {
      "touching", "in how many observations each body touched another or a wall, and when it last did",
      "observations                                 so far\n"
      "columns touched_<id>, last_touch_<id>        for each id; the time is that of the first observation\n"
      "                                             until the body touches\n"
      "A body that bears load touches in all of them, a rattler in few. Collisions are seen that last longer than\n"
      "observe_every",
      "McNamara et al. 2008, section IV B 3"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies").required();
  }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = 1 + 2 * std::uint32_t(bodies.size());
    instance.state_width = 1 + 3 * std::uint32_t(bodies.size());
  }

  scree::ColumnName column(std::uint32_t c) const {
    if (c == 0) return {"observations", "", "number so far"};
    const std::string id = std::to_string(bodies.id((c - 1) / 2));
    if (c % 2) return {"touched_" + id, "", "observations in which the body touched another or a wall"};
    return {"last_touch_" + id, "s", "time of the last of these; that of the first observation before"};
  }

  // State: number of observations; of each body the number in which it touched, the time of the last, its
  // index.
  std::string start(const scree_view& view, double* state) const {
    std::fill_n(state, 1 + 2 * bodies.size(), 0.0);
    return bodies.find(view, indices(state));
  }

  void observe(const scree_view& view, double* state) const {
    std::vector<bool> touches(view.body_count + view.plane_count + view.surface_count, false);
    for (std::uint64_t c = 0; c < view.contact_count; ++c)
      touches[view.contact_a[c]] = touches[view.contact_b[c]] = true;
    double *const touched = state + 1, *const last = touched + bodies.size();
    const bool first = state[0] == 0;
    state[0] += 1;
    for (std::uint64_t k = 0; k < bodies.size(); ++k) {
      const bool now = touches[bodies.index(view, indices(state), k)];
      touched[k] += now;
      if (now || first) last[k] = view.time;
    }
  }

  void sample(const scree_view&, const double* state, double* row) const {
    *row++ = state[0];
    for (std::uint64_t k = 0; k < bodies.size(); ++k) {
      *row++ = state[1 + k];
      *row++ = state[1 + bodies.size() + k];
    }
  }

 private:
  template <class Number>
  Number* indices(Number* state) const {
    return state + 1 + 2 * bodies.size();
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(TouchingProbe)
