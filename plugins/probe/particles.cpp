// The motion of selected bodies.

#include <scree/plugin/probe.hpp>

namespace {

struct ParticlesProbe {
  scree::BodyList bodies;
  int dimension = 3;

  static constexpr scree::About about = {
      "particles", "position, velocity, spin and force of selected bodies",
      "columns x_<id>, vx_<id>, spin_x_<id>, fx_<id> and so on for each id", "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies to record").required();
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(bodies.size()) * per_body();
    instance.state_width = std::uint32_t(bodies.size());
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* quantities[] = {"", "v", "f", "spin_"};
    static constexpr const char* units[] = {"m", "m/s", "N", "rad/s"};
    static constexpr const char* meanings[] = {"position", "velocity", "force", "angular velocity"};
    const std::uint32_t d = std::uint32_t(dimension), q = c % per_body();
    const bool is_spin = q >= 3 * d;
    const char axis = is_spin && dimension == 2 ? 'z' : "xyz"[is_spin ? q - 3 * d : q % d];
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s%c_%lld", quantities[is_spin ? 3 : q / d], axis,
                  bodies.id(c / per_body()));
    return {name, units[is_spin ? 3 : q / d], meanings[is_spin ? 3 : q / d]};
  }

  std::string start(const scree_view& view, double* indices) const { return bodies.find(view, indices); }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    bodies.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* indices, double* row) const {
    for (std::uint64_t n = 0; n < bodies.size(); ++n) {
      const std::uint64_t i = bodies.index(view, indices, n);
      for (const auto* columns : {view.position, view.velocity, view.force})
        for (int k = 0; k < dimension; ++k) *row++ = columns[k][i];
      for (int k = dimension == 2 ? 2 : 0; k < 3; ++k) *row++ = view.spin[k] ? view.spin[k][i] : 0;
    }
  }

 private:
  std::uint32_t per_body() const { return dimension == 2 ? 7 : 12; }
};

}  // namespace

SCREE_PROBE_PLUGIN(ParticlesProbe)
