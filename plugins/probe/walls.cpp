// The motion of selected walls and the loads on them.

#include <algorithm>
#include <cmath>

#include <scree/plugin/probe.hpp>

namespace {

struct WallsProbe {
  scree_value numbers = {};
  int dimension = 3;

  static constexpr scree::About about = {
      "walls", "position, velocity and load of selected walls",
      "columns position_<n>, velocity_<n>, normal_force_<n>, tangential_force_<n>, displacement_x_<n>, ...,\n"
      "force_x_<n>, ... for each wall n\n"
      "position = n·x_w, velocity = n·v_w    n: the wall's normal, pointing to the bodies\n"
      "normal_force = −n·f, above 0 if compressive; tangential_force = |f − n (n·f)|    f: of all contacts\n"
      "displacement = x_w − x_w(0), force = f, in components",
      "—"};

  void declare(scree::Declaration& d) {
    d.list(
         "walls", numbers, "", scree::Range{.minimum = 1},
         "walls to record, by name as \"box.x_low\", or numbered from 1 in the order of the [[boundary]] entries, "
         "where a box counts as x_low, x_high, y_low and so on; columns have the number")
        .required();
  }

  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_NO_BODIES;
    instance.column_count = std::uint32_t(numbers.count) * per_wall();
    instance.state_width = std::uint32_t(numbers.count) * 3;
  }

  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t q = c % per_wall(), scalars = std::uint32_t(std::size(names));
    const std::uint32_t component = q - scalars, d = std::uint32_t(dimension);
    const std::string wall = '_' + std::to_string(static_cast<long long>(numbers.data[c / per_wall()]));
    if (q < scalars) return {names[q] + wall, units[q], meanings[q]};
    const std::string axis(1, "xyz"[component % d]);
    if (component < d) return {"displacement_" + axis + wall, "m", "since the start"};
    return {"force_" + axis + wall, "N", "of all contacts on the wall"};
  }

  // State: the point of each wall at the start.
  std::string start(const scree_view& view, double* points) const {
    for (std::uint64_t k = 0; k < numbers.count; ++k) {
      if (const std::string missing = scree::missing_wall(view, numbers.data[k]); !missing.empty())
        return missing;
      std::copy_n(view.planes[std::size_t(numbers.data[k]) - 1].point, 3, points + 3 * k);
    }
    return "";
  }

  void sample(const scree_view& view, const double* points, double* row) const {
    for (std::uint64_t k = 0; k < numbers.count; ++k) {
      const auto w = std::size_t(numbers.data[k]) - 1;
      const scree_plane& plane = view.planes[w];
      const double* load = view.loads[w].force;
      const double along = dot(plane.normal, load);
      double across = 0;
      for (int i = 0; i < 3; ++i) {
        const double part = load[i] - along * plane.normal[i];
        across += part * part;
      }
      *row++ = dot(plane.normal, plane.point);
      *row++ = dot(plane.normal, plane.velocity);
      *row++ = -along;
      *row++ = std::sqrt(across);
      for (int i = 0; i < dimension; ++i) *row++ = plane.point[i] - points[3 * k + std::uint64_t(i)];
      for (int i = 0; i < dimension; ++i) *row++ = load[i];
    }
  }

 private:
  static constexpr const char* names[] = {"position", "velocity", "normal_force", "tangential_force"};
  static constexpr const char* units[] = {"m", "m/s", "N", "N"};
  static constexpr const char* meanings[] = {
      "of a point of the wall along its normal, which points to the bodies", "along the normal",
      "above 0 in compression", "magnitude"};
  std::uint32_t per_wall() const { return std::uint32_t(std::size(names)) + 2 * std::uint32_t(dimension); }
  static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

}  // namespace

SCREE_PROBE_PLUGIN(WallsProbe)
