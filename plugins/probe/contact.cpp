// Individual contacts.

#include <cmath>

#include <scree/plugin/probe.hpp>

namespace {

struct ContactProbe {
  scree_value pairs = {};
  scree_value at_walls = {};
  int dimension = 3;

  static constexpr scree::About about = {
      "contact", "overlap, force and normal of selected contacts, 0 while they are open",
      "columns overlap_<a>_<b>, normal_force_<a>_<b>, tangential_force_<a>_<b>, sliding_<a>_<b>,\n"
      "        normal_x_<a>_<b> and so on for each pair of bodies; ..._<a>_wall<n> for a body at a wall\n"
      "normal from b to a; normal_force = n·f, above 0 if repulsive; tangential_force = |f − n (n·f)|",
      "—"};

  void declare(scree::Declaration& d) {
    d.list("pairs", pairs, "", scree::Range{.minimum = 1}, "ids of the bodies, two for each contact")
        .optional();
    d.list("at_walls", at_walls, "", scree::Range{.minimum = 1},
           "for each contact the id of the body and the number of the wall; "
           "walls are numbered from 1 in the order of the [[boundary]] entries")
        .optional();
  }

  void prepare(const scree::Setup& setup) {
    dimension = setup.dimension();
    if (pairs.count % 2 || at_walls.count % 2)
      return setup.refuse("a list has an odd number of entries; give two for each contact");
    if (pairs.count + at_walls.count == 0)
      return setup.refuse("no contact is selected; give pairs = [a, b] or at_walls = [id, wall]");
  }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = std::uint32_t(pairs.count + at_walls.count) / 2 * per_contact();
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"overlap",  "normal_force", "tangential_force", "sliding",
                                            "normal_x", "normal_y",     "normal_z"};
    static constexpr const char* units[] = {"m", "N", "N", "", "", "", ""};
    const std::uint64_t entry = c / per_contact();
    const bool at_wall = 2 * entry >= pairs.count;
    const double* ends = at_wall ? at_walls.data + (2 * entry - pairs.count) : pairs.data + 2 * entry;
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s_%lld_%s%lld", names[c % per_contact()],
                  static_cast<long long>(ends[0]), at_wall ? "wall" : "", static_cast<long long>(ends[1]));
    return {name, units[c % per_contact()]};
  }

  const char* start(const scree_view& view, double*) const {
    for (std::uint64_t k = 0; k < pairs.count; ++k)
      if (scree::index_of_body(view, pairs.data[k]) == view.body_count) return no_body;
    for (std::uint64_t k = 0; k < pairs.count; k += 2)
      if (pairs.data[k] == pairs.data[k + 1]) return "a pair in `pairs` has the same id twice; give two ids";
    for (std::uint64_t k = 0; k < at_walls.count; k += 2) {
      if (scree::index_of_body(view, at_walls.data[k]) == view.body_count) return no_body;
      const double wall = at_walls.data[k + 1];
      if (wall > view.plane_count || wall != std::floor(wall))
        return "a wall in `at_walls` does not exist in this scene; "
               "walls are numbered from 1 in the order of the [[boundary]] entries";
    }
    return nullptr;
  }

  void sample(const scree_view& view, const double*, double* row) const {
    for (std::uint64_t k = 0; k < pairs.count; k += 2, row += per_contact())
      record(view, scree::index_of_body(view, pairs.data[k]), scree::index_of_body(view, pairs.data[k + 1]),
             row);
    for (std::uint64_t k = 0; k < at_walls.count; k += 2, row += per_contact())
      record(view, scree::index_of_body(view, at_walls.data[k]),
             view.body_count + std::uint64_t(at_walls.data[k + 1]) - 1, row);
  }

 private:
  static constexpr const char* no_body =
      "an id does not exist in this scene; bodies without an id are numbered from 1";

  std::uint32_t per_contact() const { return 4 + std::uint32_t(dimension); }

  // Writes the row of the contact of a and b, in whichever order the host lists them.
  void record(const scree_view& view, std::uint64_t a, std::uint64_t b, double* row) const {
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      const bool forward = view.contact_a[c] == a && view.contact_b[c] == b;
      if (!forward && (view.contact_a[c] != b || view.contact_b[c] != a)) continue;
      const double* normal = view.contact_normal + 3 * c;
      const double* force = view.contact_force + 3 * c;
      const double along = normal[0] * force[0] + normal[1] * force[1] + normal[2] * force[2];
      double across = 0;
      for (int k = 0; k < 3; ++k) across += (force[k] - along * normal[k]) * (force[k] - along * normal[k]);
      row[0] = view.contact_overlap[c];
      row[1] = along;
      row[2] = std::sqrt(across);
      row[3] = view.contact_sliding[c];
      for (int k = 0; k < dimension; ++k) row[4 + k] = forward ? normal[k] : -normal[k];
    }
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(ContactProbe)
