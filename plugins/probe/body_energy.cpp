// Kinetic energy of selected bodies, relative to its initial value.

#include <algorithm>

#include <scree/plugin/probe.hpp>

namespace {

struct BodyEnergyProbe {
  scree::BodyList bodies;

  static constexpr scree::About about = {"body_energy",
                                         "kinetic energy of selected bodies relative to their first sample",
                                         "ratio_<id> = E/E_0, E = ½ m v² + ½ I ω²    I: moment of inertia\n"
                                         "smallest_ratio, largest_ratio: over the selected bodies",
                                         "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies to record").required();
  }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(bodies.size()) + 2;
    instance.state_width = 2 * std::uint32_t(bodies.size());  // indices and first energies
  }

  scree::ColumnName column(std::uint32_t c) const {
    if (c == 0) return {"smallest_ratio", "", "of the selected bodies"};
    if (c == 1) return {"largest_ratio", "", "of the selected bodies"};
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "ratio_%lld", bodies.id(c - 2));
    return {name, "", "kinetic energy of the body / that at the first sample"};
  }

  std::string start(const scree_view& view, double* state) const {
    if (const std::string missing = bodies.find(view, state); !missing.empty()) return missing;
    for (std::uint64_t k = 0; k < bodies.size(); ++k) {
      double& first = state[bodies.size() + k] = energy(view, bodies.index(view, state, k));
      if (!(first > 0))
        return "body " + std::to_string(bodies.id(k)) +
               " is at rest at the first sample and has no reference energy; remove its id, or give it a "
               "velocity";
    }
    return "";
  }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    bodies.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    const double* const first = state + bodies.size();
    double* const ratios = row + 2;
    for (std::uint64_t k = 0; k < bodies.size(); ++k)
      ratios[k] = energy(view, bodies.index(view, state, k)) / first[k];
    row[0] = *std::min_element(ratios, ratios + bodies.size());
    row[1] = *std::max_element(ratios, ratios + bodies.size());
  }

 private:
  static double energy(const scree_view& view, std::uint64_t i) {
    const scree::Vec3 velocity = scree::vector_of(view.velocity, i), spin = scree::vector_of(view.spin, i);
    const double inertia = view.inertia ? view.inertia[i] : 0;
    return 0.5 * (view.mass[i] * dot(velocity, velocity) + inertia * dot(spin, spin));
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(BodyEnergyProbe)
