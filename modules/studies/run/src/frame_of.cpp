#include <algorithm>
#include <cmath>

#include <scree/body_bounds.hpp>
#include <scree/pictures/view_range.hpp>
#include <scree/run/frame_of.hpp>
#include <scree/run/run_in_memory.hpp>
#include <scree/surface_outline.hpp>

namespace scree::run {

namespace {

// (3N) from columns; zeros for columns that the scene lacks.
std::vector<double> interleave(const Vectors<const double>& vectors, std::size_t count) {
  std::vector<double> all(3 * count, 0.0);
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < vectors[k].size(); ++i) all[3 * i + std::size_t(k)] = vectors[k][i];
  return all;
}

void add_bodies(const Particles& p, pictures::Frame& frame) {
  frame.id.assign(p.id.begin(), p.id.end());
  frame.radius.assign(p.radius().begin(), p.radius().end());
  frame.material.assign(p.material.begin(), p.material.end());
  frame.position = interleave(p.position(), p.size());
  frame.velocity = interleave(p.velocity(), p.size());
  frame.force = interleave(p.force(), p.size());
  if (p.has_spin()) frame.spin = interleave(p.spin(), p.size());
}

// The bodies at t = 0 are in every state, so that a run that goes on has the same displacements.
void add_displacements(const Simulation& s, pictures::Frame& frame) {
  const std::vector<Vec3> now = unwrapped_positions(s);
  for (std::size_t i = 0; i < now.size(); ++i)
    for (int k = 0; k < 3; ++k)
      frame.displacement.push_back(k < s.dimension() ? now[i][k] - s.scene().bodies[i].position[k] : 0);
}

// A body in several groups counts in the first.
void add_groups(const Simulation& s, pictures::Frame& frame) {
  frame.group.assign(frame.particle_count(), -1);
  for (const BodySelection& selection : s.scene().selections) {
    const auto number = std::int32_t(frame.groups.size());
    frame.groups.push_back(selection.name);
    for (const std::uint32_t i : selection.bodies)
      if (frame.group[i] < 0) frame.group[i] = number;
  }
}

// What a table of contacts says of contact c besides its numbers in the picture.
void add_table_row(const Simulation& s, const ContactList& list, std::size_t c, pictures::Frame& frame) {
  const Particles& p = s.particles();
  const std::uint32_t a = list.a[c], b = list.b[c];
  const bool wall = b >= p.size();
  frame.contact_a.push_back(p.id[a]);
  frame.contact_b.push_back(wall ? -1 : p.id[b]);
  // Among the walls of the frame, which has no absent ones, planes first.
  const auto first = s.absent_walls().begin();
  frame.contact_wall.push_back(wall ? std::int32_t(std::count(first, first + (b - p.size()), 0)) : -1);
  const double arm = p.radius()[a] - 0.5 * list.overlap[c];
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = list.normal[3 * c + k];
    frame.contact_normal.push_back(n);
    frame.contact_force.push_back(list.force[3 * c + k]);
    frame.contact_point.push_back(frame.position[3 * a + k] - arm * n);
  }
}

void add_contacts(const Simulation& s, pictures::Frame& frame) {
  const Particles& p = s.particles();
  const ContactList list = s.contact_list();
  frame.coordination.assign(p.size(), 0);
  for (std::size_t c = 0; c < list.size(); ++c) {
    const std::uint32_t a = list.a[c], b = list.b[c];
    const bool wall = b >= p.size();
    ++frame.coordination[a];
    if (!wall) ++frame.coordination[b];
    const double distance = p.radius()[a] + (wall ? 0 : p.radius()[b]) - list.overlap[c];
    double normal_force = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = frame.position[3 * a + k], n = list.normal[3 * c + k], f = list.force[3 * c + k];
      frame.contact_from.push_back(from);
      frame.contact_to.push_back(from - distance * n);
      normal_force += f * n;
      square += f * f;
    }
    frame.contact_normal_force.push_back(normal_force);
    frame.contact_tangential_force.push_back(std::sqrt(std::max(0.0, square - normal_force * normal_force)));
    frame.contact_overlap.push_back(list.overlap[c]);
    frame.contact_sliding.push_back(list.sliding[c]);
    add_table_row(s, list, c, frame);
  }
}

// Contacts of the last evaluation with a surface.
struct WallContacts {
  std::vector<Vec3> point;   // (m) of the surface
  std::vector<Vec3> force;   // (N) on the surface
  std::vector<Vec3> normal;  // unit, to the body
};

WallContacts contacts_with(const Simulation& s, const ContactList& list, std::size_t surface) {
  const Particles& p = s.particles();
  WallContacts found;
  for (std::size_t c = 0; c < list.size(); ++c) {
    if (list.b[c] != p.size() + s.planes().size() + surface) continue;
    Vec3 centre = {}, normal = {}, force = {};
    for (int k = 0; k < 3; ++k) {
      if (k < s.dimension()) centre[k] = p.position()[k][list.a[c]];
      normal[k] = list.normal[3 * c + std::size_t(k)];
      force[k] = -list.force[3 * c + std::size_t(k)];
    }
    found.point.push_back(centre - (p.radius()[list.a[c]] - list.overlap[c]) * normal);
    found.force.push_back(force);
    found.normal.push_back(normal);
  }
  return found;
}

Vec3 corner(const std::array<double, 3>& x) { return {{x[0], x[1], x[2]}}; }

SurfaceOutline outline(const Simulation& s, std::size_t surface, const SceneBox& box) {
  return outline_of(s.surfaces(), surface, s.dimension(), corner(box.lower), corner(box.upper));
}

// Stresses of the last evaluation, and work since the start.
void add_maps(const FacetedSurface& of, const WallContacts& contacts, const std::vector<double>& work,
              pictures::Surface& surface) {
  std::vector<double> normal(of.area.size(), 0.0);
  std::vector<Vec3> force(of.area.size()), shear(of.area.size());
  for (std::size_t c = 0; c < contacts.point.size(); ++c) {
    const std::uint32_t facet = of.of_point[c];
    const double along = dot(contacts.force[c], contacts.normal[c]);
    normal[facet] -= along;
    force[facet] += contacts.force[c];
    shear[facet] += contacts.force[c] - along * contacts.normal[c];
  }
  for (const std::uint32_t facet : of.facet) {
    const double area = of.area[facet];
    const Vec3 traction = 1 / area * force[facet];
    surface.normal_stress.push_back(normal[facet] / area);
    surface.shear_stress.push_back(norm(shear[facet]) / area);
    surface.traction.insert(surface.traction.end(), traction.component, traction.component + 3);
    if (!work.empty()) surface.sliding_work.push_back(work[facet] / area);
  }
}

void add_surfaces(const Simulation& s, const SceneBox& box, pictures::Frame& frame) {
  if (s.surfaces().size() == 0) return;
  const ContactList list = s.loaded_contact_list();
  for (std::size_t k = 0; k < s.surfaces().size(); ++k) {
    if (s.absent_walls()[s.planes().size() + k]) continue;
    const WallContacts contacts = contacts_with(s, list, k);
    const FacetedSurface shape =
        facets_of(s.surfaces(), k, s.dimension(), corner(box.lower), corner(box.upper), contacts.point);
    pictures::Surface& surface = frame.surfaces.emplace_back();
    surface.name = s.surfaces().names[k];
    for (const Vec3& p : shape.outline.points)
      surface.points.insert(surface.points.end(), p.component, p.component + 3);
    surface.cells = shape.outline.cells;
    add_maps(shape, contacts, s.sliding_work(k), surface);
    std::copy_n(s.surfaces().loads[k].force, 3, surface.force.begin());
    std::copy_n(s.surfaces().loads[k].torque, 3, surface.torque.begin());
  }
}

}  // namespace

SceneBox scene_box(const Simulation& s) {
  SceneBox box;
  std::vector<Body> present;
  for (std::size_t i = 0; i < s.particles().size(); ++i) present.push_back(s.particles().body(i));
  const BodyBounds bodies = bounds_of(present, s.dimension());
  double extent = 0;
  for (int k = 0; k < s.dimension(); ++k) extent = std::max(extent, bodies.upper[k] - bodies.lower[k]);
  for (std::size_t k = 0; k < std::size_t(s.dimension()); ++k) {
    double low = bodies.lower[int(k)], high = bodies.upper[int(k)];
    for (const scree_plane& plane :
         s.planes())  // those that are absent too, so that no view jumps when they come
      if (std::abs(plane.normal[k]) > 0.999 &&
          pictures::within_view(plane.point[k], bodies.lower[int(k)], bodies.upper[int(k)], extent))
        low = std::min(low, plane.point[k]), high = std::max(high, plane.point[k]);
    const Domain& domain = s.domain();
    if (domain.periodic[k])
      low = std::min(low, domain.lower[int(k)]), high = std::max(high, domain.upper[int(k)]);
    box.lower[k] = low, box.upper[k] = high;
  }
  // What of surfaces is near enough.
  const SceneBox without = box;
  for (std::size_t surface = 0; surface < s.surfaces().size(); ++surface)
    for (const Vec3& point : outline(s, surface, without).points)
      for (std::size_t k = 0; k < std::size_t(s.dimension()); ++k)
        if (pictures::within_view(point[int(k)], bodies.lower[int(k)], bodies.upper[int(k)], extent)) {
          box.lower[k] = std::min(box.lower[k], point[int(k)]);
          box.upper[k] = std::max(box.upper[k], point[int(k)]);
        }
  return box;
}

SceneBox next_view(const SceneBox& shown, const SceneBox& scene) {
  constexpr double well_filled = 0.7, room = 0.15;
  const auto extent = [](const SceneBox& box, std::size_t k) { return box.upper[k] - box.lower[k]; };
  double largest = 0, largest_shown = 0;
  bool outgrown = false;
  for (std::size_t k = 0; k < 3; ++k) {
    largest = std::max(largest, extent(scene, k));
    largest_shown = std::max(largest_shown, extent(shown, k));
    const double slack = 1e-3 * extent(shown, k);
    outgrown |= scene.lower[k] < shown.lower[k] - slack || scene.upper[k] > shown.upper[k] + slack;
  }
  if (largest_shown == 0) return scene;
  if (!outgrown && largest >= well_filled * largest_shown) return shown;
  SceneBox next = scene;
  for (std::size_t k = 0; k < 3; ++k) {
    if (scene.lower[k] < shown.lower[k]) next.lower[k] -= room * extent(scene, k);
    if (scene.upper[k] > shown.upper[k]) next.upper[k] += room * extent(scene, k);
  }
  return next;
}

pictures::Frame frame_of(const Simulation& s, const std::string& title, const SceneBox& box,
                         const std::string& color_by) {
  pictures::Frame frame;
  frame.time = s.time();
  frame.step = s.steps();
  frame.dimension = s.dimension();
  frame.title = title;
  add_bodies(s.particles(), frame);
  add_contacts(s, frame);
  if (color_by.starts_with("displacement")) add_displacements(s, frame);
  if (color_by == "group") add_groups(s, frame);
  for (std::size_t w = 0; w < s.planes().size(); ++w) {
    if (s.absent_walls()[w]) continue;
    const scree_plane& plane = s.planes()[w];
    frame.walls.push_back({s.plane_names()[w],
                           {plane.point[0], plane.point[1], plane.point[2]},
                           {plane.normal[0], plane.normal[1], plane.normal[2]}});
  }
  add_surfaces(s, box, frame);
  frame.lower = box.lower;
  frame.upper = box.upper;
  return frame;
}

}  // namespace scree::run
