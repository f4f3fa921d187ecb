// Kinetic energy of selected bodies, relative to its initial value.

#include <algorithm>

#include <scree/plugin/probe.hpp>

namespace {

struct BodyEnergyProbe {
  scree_value ids = {};
  int dimension = 3;

  static constexpr scree::About about = {
      "body_energy", "kinetic energy of selected bodies relative to their first sample",
      "ratio_<id> = E/E_0, E = ½ m v² + ½ I ω²    I = 2mR²/5 of a sphere, mR²/2 of a disc\n"
      "smallest_ratio, largest_ratio: over the selected bodies",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", ids, "", scree::Range{.minimum = 1}, "ids of the bodies to record").required();
  }
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(ids.count) + 2;
    instance.state_width = std::uint32_t(ids.count);
  }

  scree::ColumnName column(std::uint32_t c) const {
    if (c < 2) return {c == 0 ? "smallest_ratio" : "largest_ratio", ""};
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "ratio_%lld", static_cast<long long>(ids.data[c - 2]));
    return {name, ""};
  }

  const char* start(const scree_view& view, double* first) const {
    for (std::uint64_t k = 0; k < ids.count; ++k) {
      const std::uint64_t i = scree::index_of_body(view, ids.data[k]);
      if (i == view.body_count)
        return "an id in `ids` does not exist in this scene; bodies without an id are numbered from 1";
      first[k] = energy(view, i);
      if (!(first[k] > 0))
        return "a body in `ids` is at rest at the first sample and has no reference energy; "
               "remove its id, or give it a velocity";
    }
    return nullptr;
  }

  void sample(const scree_view& view, const double* first, double* row) const {
    double* const ratios = row + 2;
    for (std::uint64_t k = 0; k < ids.count; ++k)
      ratios[k] = energy(view, scree::index_of_body(view, ids.data[k])) / first[k];
    row[0] = *std::min_element(ratios, ratios + ids.count);
    row[1] = *std::max_element(ratios, ratios + ids.count);
  }

 private:
  double energy(const scree_view& view, std::uint64_t i) const {
    const scree::Vec3 velocity = scree::vector_of(view.velocity, i), spin = scree::vector_of(view.spin, i);
    const double gyration2 = (dimension == 2 ? 0.5 : 0.4) * view.radius[i] * view.radius[i];
    return 0.5 * view.mass[i] * (dot(velocity, velocity) + gyration2 * dot(spin, spin));
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(BodyEnergyProbe)
