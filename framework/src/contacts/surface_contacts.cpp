#include "contacts/surface_contacts.hpp"

#include <algorithm>
#include <utility>

namespace scree {

namespace {

// A body that is larger than the hollow in which it lies would have an effective radius below 0: it has at
// most this many times its own.
constexpr double largest_effective_radius = 1e3;

void set_part(double* part, const Vec3& v) { std::copy_n(v.component, 3, part); }

// A record as of a body at the nearest point, see scree::record.
void write_record(const PlacedSurface& surface, const Vec3& point, int dimension, bool spin, double* at) {
  const Vec3 from_origin = point - surface.origin();
  const Vec3 velocity = surface.velocity(from_origin), mid_velocity = surface.mid_velocity(from_origin);
  if (dimension == 2) {
    const auto set = [&](std::size_t part, const Vec3& v, double third) {
      at[part] = v[0], at[part + 1] = v[1], at[part + 2] = third;
    };
    set(record::position, point, 0);
    set(record::motion, velocity, surface.spin()[2]);
    set(record::mid_motion, mid_velocity, surface.mid_spin()[2]);
    return;
  }
  set_part(at + record::position, point);
  set_part(at + record::motion, velocity);
  set_part(at + record::mid_motion, mid_velocity);
  if (!spin) return;
  set_part(at + record::spin, surface.spin());
  set_part(at + record::mid_spin, surface.mid_spin());
}

}  // namespace

void SurfaceContacts::plan(const Contacts& contacts, std::size_t record_width) {
  std::vector<std::size_t> first_row;
  std::size_t rows = 0;
  any_ = false;
  for (const PairGroup& group : contacts.groups()) {
    first_row.push_back(rows);
    if (group.surfaces) rows += group.padded_size(), any_ = any_ || group.pairs > 0;
  }
  records_.plan(std::move(first_row), rows, record_width);
}

void SurfaceContacts::place(std::vector<PlacedSurface> surfaces, std::size_t planes) {
  surfaces_ = std::move(surfaces);
  planes_ = planes;
}

void SurfaceContacts::resolve(std::size_t tile, const Contacts& contacts, const Particles& particles,
                              PairConstants& constants) {
  PairColumns& radii = constants.terms[SCREE_EFFECTIVE_RADIUS - SCREE_REDUCED_MASS];
  for (std::size_t g = 0; g < contacts.groups().size(); ++g) {
    const PairGroup& group = contacts.groups()[g];
    if (!group.surfaces || group.runs.empty()) continue;
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q)
      resolve_pair(q, records_.first_row(g) + q - group.begin, contacts, particles,
                   radii.size() > 0 ? radii.column(0) + q : nullptr);
  }
}

// 1/R* = 1/R + κ: exact for spheres; for cylinders and cones, whose contacts are elliptic, of second order in
// R κ.
void SurfaceContacts::resolve_pair(std::size_t pair, std::size_t row, const Contacts& contacts,
                                   const Particles& p, double* effective_radius) {
  const std::uint32_t a = contacts.a[pair];
  const PlacedSurface& surface = surfaces_[contacts.b[pair] - planes_];
  Vec3 x = {};
  for (int k = 0; k < p.dimension(); ++k) x[k] = p.position()[k][a];
  const NearestPoint nearest = surface.nearest(x);
  write_record(surface, nearest.point, p.dimension(), p.has_spin(), records_.record(row));
  set_part(records_.normal(row), nearest.normal);
  set_part(records_.lever(row), nearest.point - surface.origin());
  if (!effective_radius) return;
  const double curvature = 1 / p.radius()[a];
  *effective_radius = 1 / std::max(curvature + nearest.curvature, curvature / largest_effective_radius);
}

}  // namespace scree
