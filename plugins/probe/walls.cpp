// The motion of selected walls and the loads on them.

#include <cmath>

#include <scree/plugin/probe.hpp>

namespace {

struct WallsProbe {
  scree_value numbers = {};

  static constexpr scree::About about = {
      "walls", "position, velocity and load of selected walls",
      "columns position_<n>, velocity_<n>, normal_force_<n>, tangential_force_<n> for each wall n\n"
      "position = n·x_w, velocity = n·v_w    n: the wall's normal, pointing to the bodies\n"
      "normal_force = −n·f, above 0 if compressive; tangential_force = |f − n (n·f)|    f: of all contacts",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("walls", numbers, "", scree::Range{.minimum = 1},
           "walls to record, numbered from 1 in the order of the [[boundary]] entries; "
           "a box counts as x_low, x_high, y_low and so on")
        .required();
  }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(numbers.count) * std::uint32_t(std::size(names));
  }

  scree::ColumnName column(std::uint32_t c) const {
    const std::size_t q = c % std::size(names);
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s_%lld", names[q],
                  static_cast<long long>(numbers.data[c / std::size(names)]));
    return {name, units[q]};
  }

  std::string start(const scree_view& view, double*) const {
    for (std::uint64_t k = 0; k < numbers.count; ++k)
      if (const std::string missing = scree::missing_wall(view, numbers.data[k]); !missing.empty())
        return missing;
    return "";
  }

  void sample(const scree_view& view, const double*, double* row) const {
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
    }
  }

 private:
  static constexpr const char* names[] = {"position", "velocity", "normal_force", "tangential_force"};
  static constexpr const char* units[] = {"m", "m/s", "N", "N"};
  static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

}  // namespace

SCREE_PROBE_PLUGIN(WallsProbe)
