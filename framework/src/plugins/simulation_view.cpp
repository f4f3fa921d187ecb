#include "plugins/view_columns.hpp"

#include <array>
#include <bit>
#include <limits>

#include <scree/probes.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

namespace {

scree_energy no_energy() {
  std::array<double, sizeof(scree_energy) / sizeof(double)> all;
  all.fill(std::numeric_limits<double>::quiet_NaN());
  return std::bit_cast<scree_energy>(all);
}

void point_to(scree_column (&columns)[3], const Vectors<const double>& vectors) {
  for (int k = 0; k < 3; ++k) columns[k] = {vectors[k].data(), vectors[k].stride()};
}

std::vector<const char*> pointers_to(const std::vector<std::string>& names) {
  std::vector<const char*> pointers;
  for (const std::string& name : names) pointers.push_back(name.c_str());
  return pointers;
}

}  // namespace

void show(const Particles& p, scree_view& view) {
  view.body_count = p.size();
  point_to(view.position, p.position());
  point_to(view.velocity, p.velocity());
  point_to(view.spin, p.spin());
  point_to(view.force, p.force());
  point_to(view.torque, p.torque());
  view.radius = {p.radius().data(), p.radius().stride()};
  view.mass = {p.mass.data(), 1};
  if (p.has_spin()) view.inertia = {p.inertia.data(), 1};
  for (int k = 0; k < p.orientations.components(); ++k)
    view.orientation[k] = {p.orientations[k].data(), p.orientations[k].stride()};
  view.id = p.id.data();
  view.material = p.material.data();
  view.fixed = p.fixed.empty() ? nullptr : p.fixed.data();
  view.held = p.held.empty() ? nullptr : p.held.data();
  for (int k = 0; k < p.dimension(); ++k) view.image[k] = p.image[k].empty() ? nullptr : p.image[k].data();
}

void show(const ContactList& contacts, scree_view& view) {
  view.contact_count = contacts.size();
  view.contact_a = contacts.a.data();
  view.contact_b = contacts.b.data();
  view.contact_normal = contacts.normal.data();
  view.contact_overlap = contacts.overlap.data();
  view.contact_force = contacts.force.data();
  view.contact_sliding = contacts.sliding.data();
}

SimulationView::SimulationView(const Simulation& s, std::uint32_t needs, double end_time,
                               const ListedBodies& listed)
    : energy_((needs & SCREE_NEEDS_ENERGY) && s.scene().audit ? s.energy() : no_energy()) {
  view_.struct_size = sizeof(view_);
  view_.dimension = std::uint32_t(s.dimension());
  view_.time = s.time();
  view_.step_length = s.step_length();
  view_.step = s.steps();
  view_.body_count = s.scene().bodies.size();
  if (!(needs & SCREE_NEEDS_NO_BODIES)) show(listed ? s.particles(*listed) : s.particles(), view_);
  show_boundaries(s);
  if (needs & SCREE_NEEDS_CONTACTS) show(contacts_ = s.contact_list(), view_);
  view_.energy = &energy_;
  view_.end_time = end_time;
}

void SimulationView::show_boundaries(const Simulation& s) {
  for (int k = 0; k < 3; ++k) {
    view_.period[k] = s.domain().periodic[std::size_t(k)] ? s.domain().length(k) : 0;
    view_.length[k] = s.lengths()[k];
    view_.length_at_start[k] = s.lengths_at_start()[k];
  }
  plane_names_ = pointers_to(s.plane_names());
  view_.plane_count = std::uint32_t(s.planes().size());
  view_.planes = s.planes().data();
  view_.loads = s.loads().data();
  view_.plane_names = plane_names_.data();
  material_names_ = pointers_to(s.scene().materials);
  view_.material_count = std::uint32_t(material_names_.size());
  view_.material_names = material_names_.data();
  view_.plane_absent = s.absent_walls().data();
  const WallSurfaces& surfaces = s.surfaces();
  surface_names_ = pointers_to(surfaces.names);
  view_.surface_count = std::uint32_t(surfaces.size());
  view_.frames = surfaces.frames.data();
  view_.frame_loads = surfaces.loads.data();
  view_.surface_names = surface_names_.data();
}

}  // namespace scree
