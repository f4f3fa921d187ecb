// Differences in the motion of pairs of bodies, for example of two copies of a scene.

#include <cmath>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/vec.hpp>

namespace {

struct DifferenceProbe {
  scree::BodyList bodies;
  int dimension = 3;

  static constexpr scree::About about = {
      "difference", "motion of one body minus that of another, for pairs of bodies",
      "x_<a>_<b> = x_a − x_b, vx_<a>_<b> = v_a − v_b, spin_x_<a>_<b> = ω_a − ω_b and so on;\n"
      "speed_<a>_<b> = |v_a| − |v_b|, spin_<a>_<b> = |ω_a| − |ω_b|: invariant under rotation of the scene",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("ids", bodies.ids, "", scree::body_ids, "ids in pairs: a, b, a, b, ...").required();
  }
  void prepare(const scree::Setup& setup) {
    dimension = setup.dimension();
    if (bodies.size() % 2) setup.refuse("ids has an odd number of entries; give them in pairs");
  }

  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(bodies.size() / 2) * per_pair();
    instance.state_width = std::uint32_t(bodies.size());
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* spatial[] = {"x",      "y",      "z",      "vx",    "vy",  "vz",
                                              "spin_x", "spin_y", "spin_z", "speed", "spin"};
    static constexpr const char* flat[] = {"x", "y", "vx", "vy", "spin_z", "speed", "spin"};
    const std::uint32_t pair = c / per_pair(), q = c % per_pair(), d = std::uint32_t(dimension);
    const bool velocity = q < 2 * d || q == per_pair() - 2;
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s_%lld_%lld", dimension == 2 ? flat[q] : spatial[q],
                  bodies.id(2 * pair), bodies.id(2 * pair + 1));
    const char* const meaning =
        q < per_pair() - 2 ? "of body a minus that of body b" : "magnitude for body a minus that for body b";
    return {name, q < d ? "m" : velocity ? "m/s" : "rad/s", meaning};
  }

  std::string start(const scree_view& view, double* indices) const { return bodies.find(view, indices); }

  void mark_bodies(const scree_view& view, const double* state, std::uint8_t* marks) const {
    bodies.mark(view, state, marks);
  }

  void sample(const scree_view& view, const double* indices, double* row) const {
    for (std::uint64_t n = 0; n < bodies.size(); n += 2) {
      const std::uint64_t a = bodies.index(view, indices, n), b = bodies.index(view, indices, n + 1);
      for (const auto* columns : {&view.position, &view.velocity, &view.spin}) {
        const scree::Vec3 difference = scree::vector_of(*columns, a) - scree::vector_of(*columns, b);
        const bool of_disc = columns == &view.spin && dimension == 2;
        for (int k = of_disc ? 2 : 0; k < (of_disc ? 3 : dimension); ++k) *row++ = difference[k];
      }
      *row++ = norm(scree::vector_of(view.velocity, a)) - norm(scree::vector_of(view.velocity, b));
      *row++ = norm(scree::vector_of(view.spin, a)) - norm(scree::vector_of(view.spin, b));
    }
  }

 private:
  std::uint32_t per_pair() const { return dimension == 2 ? 7 : 11; }
};

}  // namespace

SCREE_PROBE_PLUGIN(DifferenceProbe)
