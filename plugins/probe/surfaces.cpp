// The motion of selected surfaces and the loads on them.

#include <array>
#include <iterator>
#include <optional>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/unit_vector.hpp>

namespace {

struct SurfacesProbe {
  scree_value numbers = {};
  std::optional<std::array<double, 3>> about_point;
  int dimension = 3;

  static constexpr scree::About about = {
      "surfaces",
      "position, velocity, spin and load of selected surfaces, which are walls that are no planes",
      "columns x_<n>, ..., velocity_x_<n>, ..., spin_x_<n>, ..., force_x_<n>, ..., torque_x_<n>, ..., power_<n>\n"
      "x: the point of the boundary, as it has moved, such as the centre of a disc; in 2D spin and torque about z\n"
      "torque of the bodies on the surface, about that point, which moves along, or about `about`: the parts of one machine are added\n"
      "up about one point; power = −F·v − T·ω, of the surface on the bodies, T about x",
      "—"};

  void declare(scree::Declaration& d) {
    d.list(
         "surfaces", numbers, "", scree::Range{.minimum = 1},
         "surfaces to record, by name as \"drum\" or \"drum.mantle\", or numbered from 1 in the order of the "
         "[[boundary]] entries, where planes and boxes do not count; columns have the number")
        .required();
    d.vector("about", about_point, "m", "about which torques are, such as a point of the axis of a machine")
        .optional();
  }

  void prepare(const scree::Setup& setup) { dimension = setup.dimension(); }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_NO_BODIES;
    instance.column_count = std::uint32_t(numbers.count) * per_surface();
  }

  scree::ColumnName column(std::uint32_t c) const {
    const std::string surface = '_' + std::to_string(static_cast<long long>(numbers.data[c / per_surface()]));
    std::uint32_t q = c % per_surface();
    for (const Vector& v : vectors) {
      if (q < components(v))
        return {v.name + std::string(1, "xyz"[v.turns ? first_axis() + q : q]) + surface, v.unit, v.meaning};
      q -= components(v);
    }
    return {"power" + surface, "W", "of the surface on the bodies"};
  }

  std::string start(const scree_view& view, double*) const {
    for (std::uint64_t k = 0; k < numbers.count; ++k)
      if (const std::string missing = scree::missing_surface(view, numbers.data[k]); !missing.empty())
        return missing;
    return "";
  }

  void sample(const scree_view& view, const double*, double* row) const {
    for (std::uint64_t k = 0; k < numbers.count; ++k) {
      const auto at = std::size_t(numbers.data[k]) - 1;
      const scree_frame& frame = view.frames[at];
      const scree_frame_load& load = view.frame_loads[at];
      const scree::Vec3 torque = torque_of(frame, load);
      const double* const of[] = {frame.position, frame.velocity, frame.spin, load.force, torque.component};
      for (std::size_t v = 0; v < std::size(vectors); ++v) {
        const double* const first = of[v] + (vectors[v].turns ? first_axis() : 0);
        for (std::uint32_t i = 0; i < components(vectors[v]); ++i) *row++ = first[i];
      }
      *row++ = 0.0 - dot(load.force, frame.velocity) - dot(load.torque, frame.spin);
    }
  }

 private:
  struct Vector {
    const char *name, *unit, *meaning;
    bool turns;  // about axes: in 2D about z alone
  };
  static constexpr Vector vectors[] = {
      {"", "m", "of its point, as it has moved", false},
      {"velocity_", "m/s", "of its point", false},
      {"spin_", "rad/s", "of the surface", true},
      {"force_", "N", "of all contacts on the surface", false},
      {"torque_", "N m", "of all contacts, about its point, or `about`", true}};

  scree::Vec3 torque_of(const scree_frame& frame, const scree_frame_load& load) const {
    const auto vector = [](const double(&v)[3]) { return scree::Vec3{{v[0], v[1], v[2]}}; };
    if (!about_point) return vector(load.torque);
    const scree::Vec3 arm = vector(frame.position) - scree::vector_of(*about_point);
    return vector(load.torque) + cross(arm, vector(load.force));
  }
  std::uint32_t first_axis() const { return dimension == 2 ? 2 : 0; }
  std::uint32_t components(const Vector& v) const {
    return v.turns ? 3 - first_axis() : std::uint32_t(dimension);
  }
  std::uint32_t per_surface() const {
    std::uint32_t count = 1;
    for (const Vector& v : vectors) count += components(v);
    return count;
  }
  static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

}  // namespace

SCREE_PROBE_PLUGIN(SurfacesProbe)
