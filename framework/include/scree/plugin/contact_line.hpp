#pragma once

#include <cstdint>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/vec.hpp>

namespace scree {

// The straight line of a contact: from the centre of b, or from a wall, through the contact point, to the
// centre of a; in the image of the scene in which a is.
struct ContactLine {
  Vec3 centre = {}, normal = {}, force = {};  // of a (m); from b to a; on a (N)
  double to_a = 0, to_b = 0;   // (m) from the contact point, the middle of the overlap; 0 to a wall
  std::uint32_t a = 0, b = 0;  // as in the view

  ContactLine(const scree_view& view, std::uint64_t contact)
      : centre(vector_of(view.position, view.contact_a[contact])),
        a(view.contact_a[contact]),
        b(view.contact_b[contact]) {
    for (int k = 0; k < 3; ++k) {
      normal[k] = view.contact_normal[3 * contact + std::uint64_t(k)];
      force[k] = view.contact_force[3 * contact + std::uint64_t(k)];
    }
    const double overlap = view.contact_overlap[contact];
    const bool wall = b >= view.body_count;
    to_a = view.radius[a] - (wall ? overlap : 0.5 * overlap);
    to_b = wall ? 0 : view.radius[b] - 0.5 * overlap;
  }

  Vec3 point() const { return centre - to_a * normal; }

  // Calls visit(start, step) for the line if the probe counts both bodies; if it counts one of them, for the
  // part between the contact point and the centre of that body.
  template <class Visit>
  void each_part(const scree_view& view, const Visit& visit) const {
    const bool with_a = counts(view, a), with_b = b >= view.body_count || counts(view, b);
    if (with_a && with_b) return visit(centre - (to_a + to_b) * normal, (to_a + to_b) * normal);
    if (with_a) visit(point(), to_a * normal);
    if (with_b && b < view.body_count) visit(centre - (to_a + to_b) * normal, to_b * normal);
  }
};

}  // namespace scree
