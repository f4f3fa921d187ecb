// Lengths, stresses and strains of a box of walls.

#include <cmath>
#include <numbers>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/walls.hpp>

namespace {

struct BoxProbe {
  int dimension = 3;

  static constexpr scree::About about = {
      "box", "lengths, stresses and strains of the box formed by opposite walls",
      "σ_kk = mean of the contact forces on the walls of axis k that are there / their area, from wall to wall\n"
      "ε_kk = 1 − L_k/L_k0          L_k0: at the first sample\n"
      "σ_D = 2(σ_xx − σ_yy)/3,  ε_D = ε_xx − ε_yy",
      "David et al. 2005, section 3.1; McNamara et al. 2008, equation 2 (γ = ε_D)"};

  void declare(scree::Declaration&) {}
  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(3 * dimension + 3);
    instance.state_width = 3;
    instance.total_count = 1;
  }

  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t d = std::uint32_t(dimension);
    const std::string axis(1, "xyz"[c % d]);
    if (c < d) return {"length_" + axis, "m", "distance between the walls"};
    if (c < 2 * d)
      return {"stress_" + axis + axis, "Pa", "mean of the walls that are there, above 0 in compression"};
    if (c < 3 * d) return {"strain_" + axis + axis, "", "1 − length / length at the first sample"};
    if (c == 3 * d) return {"deviatoric_stress", "Pa", "2 (stress_xx − stress_yy)/3"};
    if (c == 3 * d + 1) return {"deviatoric_strain", "", "strain_xx − strain_yy"};
    return {
        "solid_fraction", "",
        "volume of the bodies with centres between the walls / volume there (2D: areas); overlaps count twice"};
  }

  const char* start(const scree_view& view, double* state) const {
    for (int k = 0; k < dimension; ++k) {
      if (wall(view, k, 1) < 0 || wall(view, k, -1) < 0)
        return "the box probe needs walls at both ends of each axis; add a boundary \"box\" or planes";
      state[k] = length(view, k);
    }
    return nullptr;
  }

  // Volume of the bodies whose centres are between the walls.
  void accumulate(const scree_view& part, std::uint32_t, double* totals) const {
    constexpr double pi = std::numbers::pi;
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!is_between(part, i)) continue;
      const double r = part.radius[i];
      totals[0] += dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r;
    }
  }

  void sample(const scree_view& view, const double* state, double* row) const {
    double lengths[3] = {1, 1, 1}, volume = 1;
    for (int k = 0; k < dimension; ++k) volume *= lengths[k] = length(view, k);
    double* stress = row + dimension;
    double* strain = row + 2 * dimension;
    for (int k = 0; k < dimension; ++k) {
      row[k] = lengths[k];
      stress[k] = scree::pressing_force({view.planes, view.plane_count}, view.loads, k, view.plane_absent) /
                  (volume / lengths[k]);
      strain[k] = 1 - lengths[k] / state[k];
    }
    double* last = row + 3 * dimension;
    last[0] = 2 * (stress[0] - stress[1]) / 3;
    last[1] = strain[0] - strain[1];
    last[2] = view.totals[0] / volume;
  }

 private:
  // Index of the innermost wall at the lower (sign 1) or upper end (sign −1) of an axis, or −1.
  static int wall(const scree_view& view, int axis, int sign) {
    return scree::wall_across({view.planes, view.plane_count}, axis, sign, view.plane_absent);
  }
  static double length(const scree_view& view, int axis) {
    return view.planes[wall(view, axis, -1)].point[axis] - view.planes[wall(view, axis, 1)].point[axis];
  }
  bool is_between(const scree_view& view, std::uint64_t i) const {
    for (int k = 0; k < dimension; ++k) {
      const double x = view.position[k][i];
      if (x < view.planes[wall(view, k, 1)].point[k] || x > view.planes[wall(view, k, -1)].point[k])
        return false;
    }
    return true;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(BoxProbe)
