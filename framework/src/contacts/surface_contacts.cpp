#include "contacts/surface_contacts.hpp"

#include "machine/instruction_levels.hpp"
#include "surfaces/normal_change.hpp"

#include <algorithm>
#include <utility>

namespace scree {

namespace {

void set_part(double* part, const Vec3& v) {
  for (int k = 0; k < 3; ++k) part[k] = v[k];
}

// A record as of a body at the nearest point, see scree::record.
void write_record(const PlacedSurface& surface, const SurfacePoint& at_point, int dimension, bool spin,
                  double* at) {
  if (dimension == 2) {
    const auto set = [&](std::size_t part, const Vec3& v, double third) {
      at[part] = v[0], at[part + 1] = v[1], at[part + 2] = third;
    };
    set(record::position, at_point.point, 0);
    set(record::motion, at_point.velocity, surface.spin()[2]);
    set(record::mid_motion, at_point.mid_velocity, surface.mid_spin()[2]);
    return;
  }
  set_part(at + record::position, at_point.point);
  set_part(at + record::motion, at_point.velocity);
  set_part(at + record::mid_motion, at_point.mid_velocity);
  if (!spin) return;
  set_part(at + record::spin, surface.spin());
  set_part(at + record::mid_spin, surface.mid_spin());
}

}  // namespace

void SurfaceContacts::plan(const Contacts& contacts, std::size_t record_width,
                           const kernel::SurfaceRecords::Kept& kept) {
  std::vector<std::size_t> first_row;
  std::size_t rows = 0, tiles = 0;
  any_ = false;
  for (const PairGroup& group : contacts.groups()) {
    first_row.push_back(rows);
    tiles = std::max(tiles, group.runs.size());
    if (group.surfaces) rows += group.padded_size(), any_ = any_ || group.pairs > 0;
  }
  records_.plan(std::move(first_row), rows, record_width, kept);
  away_.assign(rows, 0);
  if (any_) mesh_spots_.resize(tiles);
  for (MeshSpots& spots : mesh_spots_) spots.renew();
}

void SurfaceContacts::place(std::vector<PlacedSurface> surfaces, std::size_t planes, const Domain& domain,
                            double step) {
  surfaces_ = std::move(surfaces);
  domain_ = domain;
  step_ = step;
  planes_ = planes;
}

void SurfaceContacts::set(std::size_t row, const PlacedSurface& surface, SurfacePoint at, const Vec3& beyond,
                          const Particles& p) {
  set_part(records_.lever(row), at.point - surface.origin());
  at.point += beyond;
  write_record(surface, at, p.dimension(), p.has_spin(), records_.record(row));
  set_part(records_.normal(row), at.normal);
  set_part(records_.mid_normal(row), at.mid_normal);
}

void SurfaceContacts::set_path(std::size_t row, const PlacedSurface& surface, int dimension, const Vec3& x,
                               const NearestPoint& nearest) {
  const auto change = symmetric_components(normal_change_in_scene(surface, dimension, x, nearest));
  std::copy(change.begin(), change.end(), records_.normal_change(row));
  const Rotation& frame = surface.to_scene();
  double* const orientation = records_.orientation(row);
  orientation[0] = frame.real;
  set_part(orientation + 1, frame.axis);
}

void SurfaceContacts::resolve_shape(const PlacedSurface& surface, const Results& to, const Particles& p,
                                    ShapeContacts& bodies) {
  if (bodies.count() == 0) return;
  bodies.find(surface, p.dimension());
  for (std::size_t k = 0; k < bodies.count(); ++k) {
    set(to.rows + bodies.pair(k), surface, bodies.point(k), bodies.beyond(k), p);
    if (to.effective_radius) to.effective_radius[bodies.pair(k)] = bodies.effective_radius(k);
    if (!records_.keep_paths()) continue;
    const Vec3 x = surface.in_frame(bodies.centre(k));
    const NearestPoint nearest = nearest_point(surface.surface(), p.dimension(), x);
    if (nearest.distance < bodies.radius(k))
      set_path(to.rows + bodies.pair(k), surface, p.dimension(), x, nearest);
  }
  bodies.clear();
}

namespace {

// Of a body.
Vec3 vector_of(const Vectors<const double>& all, std::size_t body, int dimension) {
  Vec3 v = {};
  for (int k = 0; k < dimension; ++k) v[k] = all[k][body];
  return v;
}

}  // namespace

// Farther than a body moves until the next search.
void SurfaceContacts::set_away(std::size_t row, const PairsOfBody& of, const Vec3& x, const Particles& p) {
  if (away_[row]) return;
  constexpr double radii = 1e6;
  const double distance = radii * p.radius()[of.body];
  const NearestPoint far = {x - Vec3{{0, 0, distance}}, {{0, 0, 1}}, distance, {}};
  set(row, of.surface, surface_point(of.surface, far, far), {}, p);
  away_[row] = 1;
}

SCREE_EVERY_LEVEL_INLINED void SurfaceContacts::resolve_spots(const PairsOfBody& of, const Results& to,
                                                              const Particles& p, MeshSpots& mesh_spots,
                                                              PairGroup& group) {
  const double radius = p.radius()[of.body];
  const Vec3 x = vector_of(p.position(), of.body, p.dimension()), beyond = domain_.beyond(x);
  const auto set_pair = [&](std::size_t pair, const NearestPoint& nearest, const NearestPoint& middle) {
    set(to.rows + pair, of.surface, surface_point(of.surface, nearest, middle), beyond, p);
    if (to.effective_radius) to.effective_radius[pair] = effective_radius_at(nearest.curvature, 1 / radius);
  };
  const Vec3 here = of.surface.in_frame(x - beyond);
  const SpotRule rule = of.surface.rule();
  const std::vector<NearestPoint>& spots =
      mesh_spots.find(*of.surface.mesh(), rule, {of.body, of.wall, p.order().number(of.body)},
                      {here, radius, of.end - of.begin});
  const MeshSpots::Pairs pairs = {group, of.begin, of.end};
  if (spots.empty() && !MeshSpots::touched(pairs)) {
    for (std::size_t pair = of.begin; pair < of.end; ++pair) set_away(to.rows + pair, of, x, p);
    return;
  }
  mesh_spots.follow(rule, here, spots, pairs, {domain_, of.surface.to_scene()});
  if (of.spring) mesh_spots.turn_springs(of.surface.to_scene(), spots, pairs);
  MeshSpots::keep(spots, pairs);
  for (std::size_t pair = of.begin; pair < of.end; ++pair) {
    const std::size_t spot = pair - of.begin;
    if (spot < spots.size()) {
      away_[to.rows + pair] = 0;
      set_pair(pair, of.surface.in_scene(spots[spot]),
               of.surface.mid_in_scene(mesh_spots.middle(spot, spots[spot])));
      if (records_.keep_paths()) set_path(to.rows + pair, of.surface, p.dimension(), here, spots[spot]);
    } else {
      set_away(to.rows + pair, of, x, p);
    }
  }
}

void SurfaceContacts::resolve(std::size_t tile, Contacts& contacts, const Particles& p,
                              const std::vector<std::uint8_t>& springs, PairConstants& constants) {
  PairColumns& radii = constants.terms[SCREE_EFFECTIVE_RADIUS - SCREE_REDUCED_MASS];
  // Kept from tile to tile: each is some kB.
  thread_local std::vector<ShapeContacts> shapes;
  shapes.resize(std::max(shapes.size(), surfaces_.size()));
  mesh_spots_[tile].begin();
  for (std::size_t g = 0; g < contacts.groups().size(); ++g) {
    PairGroup& group = contacts.groups()[g];
    if (!group.surfaces || group.runs.empty()) continue;
    const Results to = {records_.first_row(g) - group.begin, radii.size() > 0 ? radii.column(0) : nullptr};
    const std::size_t end = group.runs[tile].end;
    for (std::size_t q = group.runs[tile].begin, next = q; q < end; q = next) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      const PlacedSurface& surface = surfaces_[b - planes_];
      for (next = q + 1; next < end && contacts.a[next] == a && contacts.b[next] == b;) ++next;
      if (surface.mesh()) {
        resolve_spots({surface, a, b, q, next, springs[group.law] != 0}, to, p, mesh_spots_[tile], group);
        continue;
      }
      ShapeContacts& bodies = shapes[b - planes_];
      const Vec3 x = vector_of(p.position(), a, p.dimension()), beyond = domain_.beyond(x);
      const Vec3 middle = x - beyond - 0.5 * step_ * vector_of(p.mid_velocity(), a, p.dimension());
      bodies.add(q, {x - beyond, middle - domain_.beyond(middle), beyond, p.radius()[a]});
      if (bodies.full()) resolve_shape(surface, to, p, bodies);
    }
    for (std::size_t s = 0; s < surfaces_.size(); ++s) resolve_shape(surfaces_[s], to, p, shapes[s]);
  }
}

// What a law creates is left out, as in the balance of energy.
std::vector<SlidingWork::Slip> SurfaceContacts::slips_of(std::size_t tile, const Contacts& contacts,
                                                         const SlidingWork& on, int dimension,
                                                         bool backwards) {
  std::vector<SlidingWork::Slip> slips;
  for (std::size_t g = 0; g < contacts.groups().size(); ++g) {
    const PairGroup& group = contacts.groups()[g];
    if (!group.surfaces || group.runs.empty()) continue;
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q) {
      const std::size_t row = records_.first_row(g) + q - group.begin;
      const double energy = records_.slips()[row];
      if (!(backwards ? energy < 0 : energy > 0)) continue;
      const std::uint32_t surface = contacts.b[q] - std::uint32_t(planes_);
      Vec3 from_origin = {};
      std::copy_n(records_.lever(row), dimension, from_origin.component);
      const std::size_t facet = on.facets(surface).at(surfaces_[surface].to_scene().back()(from_origin));
      slips.push_back({surface, std::uint32_t(facet), energy});
    }
  }
  return slips;
}

}  // namespace scree
