// Individual contacts.

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/plugin/probe.hpp>

namespace {

struct ContactProbe {
  scree::BodyList pairs;
  scree::BodyList at_walls = {.stride = 2}, at_surfaces = {.stride = 2};
  int dimension = 3;

  static constexpr scree::About about = {
      "contact", "overlap, force and normal of selected contacts, 0 while they are open",
      "columns overlap_<a>_<b>, normal_force_<a>_<b>, tangential_force_<a>_<b>, sliding_<a>_<b>,\n"
      "        normal_x_<a>_<b> and so on for each pair of bodies; ..._<a>_wall<n> for a body at a plane,\n"
      "        ..._<a>_surface<n> at a surface; of several spots in which it touches a mesh, the deepest\n"
      "normal from b to a; normal_force = n·f, above 0 if repulsive; tangential_force = |f − n (n·f)|, in 2D\n"
      "f·(z × n) with its sign, which does not depend on the order of the bodies",
      "McNamara et al. 2008, figures 3, 4 and 7"};

  void declare(scree::Declaration& d) {
    d.list("pairs", pairs.ids, "", scree::body_ids, "ids of the bodies, two for each contact").optional();
    d.list("at_walls", at_walls.ids, "", scree::body_ids,
           "for each contact the id of the body and the number or the name of the wall; "
           "walls are planes and sides of boxes, numbered from 1 in the order of the [[boundary]] entries")
        .optional();
    d.list(
         "at_surfaces", at_surfaces.ids, "", scree::body_ids,
         "for each contact the id of the body and the number or the name of the surface, which is a wall that is "
         "no plane; surfaces are numbered from 1 in the order of the [[boundary]] entries")
        .optional();
  }

  void prepare(const scree::Setup& setup) {
    dimension = setup.dimension();
    if (pairs.ids.count % 2 || at_walls.ids.count % 2 || at_surfaces.ids.count % 2)
      return setup.refuse("a list has an odd number of entries; give two for each contact");
    if (contacts() == 0)
      return setup.refuse(
          "no contact is selected; give pairs = [a, b], at_walls = [id, wall] or at_surfaces = "
          "[id, surface]");
  }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = std::uint32_t(contacts()) * per_contact();
    instance.state_width = std::uint32_t(pairs.size() + at_walls.size() + at_surfaces.size());
  }

  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"overlap",  "normal_force", "tangential_force", "sliding",
                                            "normal_x", "normal_y",     "normal_z"};
    static constexpr const char* units[] = {"m", "N", "N", "", "", "", ""};
    static constexpr const char* meanings[] = {"0 while the contact is open",
                                               "above 0 if repulsive",
                                               "magnitude; in 2D with the sign of f·(z × n)",
                                               "1 while the contact slides, else 0",
                                               "component of the normal, from b or the wall to a",
                                               "",
                                               ""};
    const Entry entry = entry_of(c / per_contact());
    char name[SCREE_MAX_NAME];
    std::snprintf(name, sizeof(name), "%s_%lld_%s%lld", names[c % per_contact()], entry.id(), entry.partner,
                  static_cast<long long>(entry.number()));
    const std::uint32_t quantity = c % per_contact();
    return {name, units[quantity], meanings[std::min(quantity, 4u)]};
  }

  std::string start(const scree_view& view, double* indices) const {
    if (const std::string missing = pairs.find(view, indices); !missing.empty()) return missing;
    for (std::uint64_t k = 0; k < pairs.size(); k += 2)
      if (pairs.id(k) == pairs.id(k + 1)) return "a pair in `pairs` has the same id twice; give two ids";
    for (std::uint64_t k = 0; k < at_walls.size(); ++k)
      if (const std::string missing = scree::missing_wall(view, at_walls.ids.data[2 * k + 1]);
          !missing.empty())
        return missing;
    for (std::uint64_t k = 0; k < at_surfaces.size(); ++k)
      if (const std::string missing = scree::missing_surface(view, at_surfaces.ids.data[2 * k + 1]);
          !missing.empty())
        return missing;
    double* const of_walls = indices + pairs.size();
    if (const std::string missing = at_walls.find(view, of_walls); !missing.empty()) return missing;
    return at_surfaces.find(view, of_walls + at_walls.size());
  }

  void sample(const scree_view& view, const double* indices, double* row) const {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> wanted;  // key of a pair, its place in the row
    for (std::uint64_t entry = 0; entry < contacts(); ++entry)
      wanted.emplace_back(key(first(view, indices, entry), second(view, indices, entry)), entry);
    std::sort(wanted.begin(), wanted.end());
    std::fill(row, row + contacts() * per_contact(), 0.0);
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      const std::uint64_t found = key(view.contact_a[c], view.contact_b[c]);
      auto at = std::lower_bound(wanted.begin(), wanted.end(), std::pair(found, std::uint64_t(0)));
      for (; at != wanted.end() && at->first == found; ++at) {
        double* const of_contact = row + at->second * per_contact();
        if (view.contact_overlap[c] > of_contact[0])
          record(view, c, view.contact_a[c] == first(view, indices, at->second), of_contact);
      }
    }
  }

 private:
  std::uint32_t per_contact() const { return 4 + std::uint32_t(dimension); }
  std::uint64_t body_pairs() const { return pairs.size() / 2; }
  std::uint64_t contacts() const { return body_pairs() + at_walls.size() + at_surfaces.size(); }

  // A contact that the parameters name: the entry `at` of a list.
  struct Entry {
    const scree::BodyList& list;
    std::uint64_t at;
    const char* partner;             // "", "wall" or "surface"
    std::uint64_t first_index;       // in the state
    std::uint64_t walls_before = 0;  // as the host numbers them behind the bodies

    long long id() const { return static_cast<long long>(list.ids.data[2 * at]); }
    // Id of the other body, or number of the wall from 1.
    double number() const { return list.ids.data[2 * at + 1]; }
    bool is_at_wall() const { return *partner; }
  };
  Entry entry_of(std::uint64_t entry, std::uint64_t planes = 0) const {
    if (entry < body_pairs()) return {pairs, entry, "", 0};
    entry -= body_pairs();
    if (entry < at_walls.size()) return {at_walls, entry, "wall", pairs.size()};
    return {at_surfaces, entry - at_walls.size(), "surface", pairs.size() + at_walls.size(), planes};
  }

  // The ends of an entry, as the host numbers bodies and walls.
  std::uint64_t first(const scree_view& view, const double* indices, std::uint64_t number) const {
    const Entry entry = entry_of(number);
    return entry.list.index(view, indices + entry.first_index, entry.is_at_wall() ? entry.at : 2 * entry.at);
  }
  std::uint64_t second(const scree_view& view, const double* indices, std::uint64_t number) const {
    const Entry entry = entry_of(number, view.plane_count);
    if (entry.is_at_wall()) return view.body_count + entry.walls_before + std::uint64_t(entry.number()) - 1;
    return pairs.index(view, indices, 2 * entry.at + 1);
  }
  // The same for both orders of the ends.
  static std::uint64_t key(std::uint64_t a, std::uint64_t b) { return std::max(a, b) << 32 | std::min(a, b); }

  // Writes contact c; forward: it is listed in the order of the parameter.
  void record(const scree_view& view, std::uint64_t c, bool forward, double* row) const {
    const double* normal = view.contact_normal + 3 * c;
    const double* force = view.contact_force + 3 * c;
    const double along = normal[0] * force[0] + normal[1] * force[1] + normal[2] * force[2];
    double across = 0;
    for (int k = 0; k < 3; ++k) across += (force[k] - along * normal[k]) * (force[k] - along * normal[k]);
    row[0] = view.contact_overlap[c];
    row[1] = along;
    row[2] = dimension == 2 ? normal[0] * force[1] - normal[1] * force[0] : std::sqrt(across);
    row[3] = view.contact_sliding[c];
    for (int k = 0; k < dimension; ++k) row[4 + k] = forward ? normal[k] : -normal[k];
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(ContactProbe)
