// The motion of selected bodies.

#include <scree/plugin/probe.hpp>

namespace {

struct ParticlesProbe {
  scree_value ids = {};
  int dimension = 3;

  static constexpr scree::About about = {
      "particles", "position, velocity, spin and force of selected bodies",
      "columns x_<id>, vx_<id>, spin_x_<id>, fx_<id> and so on for each id", "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", ids, "", scree::Range{.minimum = 1}, "ids of the bodies to record").required();
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(ids.count) * per_body();
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* quantities[] = {"", "v", "f", "spin_"};
    static constexpr const char* units[] = {"m", "m/s", "N", "rad/s"};
    const std::uint32_t d = std::uint32_t(dimension), q = c % per_body();
    const bool is_spin = q >= 3 * d;
    const char axis = is_spin && dimension == 2 ? 'z' : "xyz"[is_spin ? q - 3 * d : q % d];
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s%c_%lld", quantities[is_spin ? 3 : q / d], axis,
                  static_cast<long long>(ids.data[c / per_body()]));
    return {name, units[is_spin ? 3 : q / d]};
  }

  const char* start(const scree_view& view, double*) const {
    for (std::uint64_t k = 0; k < ids.count; ++k)
      if (scree::index_of_body(view, ids.data[k]) == view.body_count)
        return "an id in `ids` does not exist in this scene; bodies without an id are numbered from 1";
    return nullptr;
  }

  void sample(const scree_view& view, const double*, double* row) const {
    for (std::uint64_t n = 0; n < ids.count; ++n) {
      const std::uint64_t i = scree::index_of_body(view, ids.data[n]);
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
