#include "contacts/touching_contacts.hpp"

#include "contacts/mesh_spots.hpp"
#include "surfaces/placed_surface.hpp"

#include <limits>

namespace scree {

namespace {

Vec3 position(const Particles& p, std::size_t i) {
  Vec3 x = {};
  for (int k = 0; k < p.dimension(); ++k) x[k] = p.position()[k][i];
  return x;
}

// NaN if the forces of pairs are not stored.
Vec3 force_of(const PairColumns& forces, std::size_t pair) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (forces.width() == 0) return {{unknown, unknown, unknown}};
  Vec3 force = {};
  for (std::uint32_t k = 0; k < forces.width(); ++k) force[int(k)] = forces.column(k)[pair];
  return force;
}

bool is_loaded(const PairColumns& forces, std::size_t pair) {
  const Vec3 force = force_of(forces, pair);
  return dot(force, force) > 0;
}

void append(std::vector<double>& columns, const Vec3& v) {
  columns.insert(columns.end(), v.component, v.component + 3);
}

// Where two partners meet: unit vector from b to a, and overlap (m), below 0 if they are apart.
struct Meeting {
  Vec3 normal = {};
  double overlap = 0;
};

// The walls of a scene now.
class Walls {
 public:
  explicit Walls(const Boundaries& boundaries) : planes_(boundaries.planes()), domain_(boundaries.domain()) {
    surfaces_ = placed_surfaces(boundaries.surfaces(), boundaries.dimension());
  }
  const Domain& domain() const { return domain_; }
  // Of a body with a wall.
  Meeting meeting(const Particles& p, const Contacts& contacts, const PairGroup& group,
                  std::size_t pair) const {
    const std::uint32_t wall = contacts.b[pair];
    const Vec3 x = position(p, contacts.a[pair]);
    const double radius = p.radius()[contacts.a[pair]];
    if (wall < planes_.size()) {
      const scree_plane& plane = planes_[wall];
      const Vec3 normal = {{plane.normal[0], plane.normal[1], plane.normal[2]}};
      double height = 0;
      for (int k = 0; k < 3; ++k) height += (x[k] - plane.point[k]) * normal[k];
      return {normal, radius - height};
    }
    const PlacedSurface& surface = surfaces_[wall - planes_.size()];
    const Vec3 inside = x - domain_.beyond(x);
    if (!surface.mesh()) {
      const NearestPoint nearest = surface.nearest(inside);
      return {nearest.normal, radius - nearest.distance};
    }
    const std::optional<NearestPoint> spot = spot_of_pair(
        *surface.mesh(), surface.rule(), surface.in_frame(inside), radius, contacts, group, pair);
    return spot ? Meeting{surface.in_scene(*spot).normal, radius - spot->distance} : Meeting{{}, -radius};
  }

 private:
  const std::vector<scree_plane>& planes_;
  const Domain& domain_;
  std::vector<PlacedSurface> surfaces_;
};

Meeting meeting_of(const Particles& p, const Contacts& contacts, const PairGroup& group, std::size_t pair,
                   const Walls& walls) {
  if (group.planes) return walls.meeting(p, contacts, group, pair);
  const std::uint32_t a = contacts.a[pair], b = contacts.b[pair];
  const Vec3 apart = position(p, a) - position(p, b) + walls.domain().shift(contacts.image[pair]);
  const double distance = norm(apart);
  return {(distance > 0 ? 1 / distance : 0) * apart, p.radius()[a] + p.radius()[b] - distance};
}

}  // namespace

std::size_t count_touching(const Particles& p, const Contacts& contacts, const Boundaries& boundaries) {
  const Walls walls(boundaries);
  std::size_t touching = 0;
  for (const PairGroup& group : contacts.groups())
    group.each_pair([&](std::size_t q) { touching += meeting_of(p, contacts, group, q, walls).overlap > 0; });
  return touching;
}

void count_contacts(const Particles& p, const Contacts& contacts, const Boundaries& boundaries,
                    BodyColumn<std::uint32_t>& counts) {
  const Walls walls(boundaries);
  for (const PairGroup& group : contacts.groups())
    group.each_pair([&](std::size_t q) {
      if (!(meeting_of(p, contacts, group, q, walls).overlap > 0)) return;
      ++counts[contacts.a[q]];
      if (!group.planes) ++counts[contacts.b[q]];
    });
}

namespace {

// Adds a pair to a list if it belongs there; number: which number of a body, given its place, the list has.
template <class Number>
void add_pair(const PairsNow& now, const Walls& walls, const PairGroup& group, std::size_t q,
              ListedPairs listed, const Number& number, ContactList& list) {
  const auto& [p, contacts, forces, laws, boundaries] = now;
  const std::uint32_t a = contacts.a[q], b = contacts.b[q];
  const auto [normal, overlap] = meeting_of(p, contacts, group, q, walls);
  if (!(overlap > 0) && !(listed == ListedPairs::touching_or_loaded && is_loaded(forces, q))) return;
  const int sliding_column = laws[group.law].interface.sliding_column;
  list.a.push_back(number(a));
  list.b.push_back(group.planes ? std::uint32_t(p.size()) + b : number(b));
  append(list.normal, normal);
  append(list.force, force_of(forces, q));
  list.overlap.push_back(overlap);
  list.sliding.push_back(sliding_column >= 0 && group.history_width > std::uint32_t(sliding_column) &&
                         group.history_of(q, std::uint32_t(sliding_column)) > 0);
  list.law.push_back(group.law);
  list.pair.push_back(q);
}

}  // namespace

ContactList touching_contacts(const PairsNow& now, ListedPairs listed) {
  const BodyOrder& order = now.particles.order();
  const Walls walls(now.boundaries);
  ContactList list;
  for (const PairGroup& group : now.contacts.groups())
    for (const std::size_t q : now.contacts.in_scene_order(group, order))
      add_pair(
          now, walls, group, q, listed, [&](std::uint32_t place) { return order.number(place); }, list);
  return list;
}

ContactList touching_contacts_of(const PairsNow& now, std::size_t tile) {
  const Walls walls(now.boundaries);
  ContactList list;
  for (const PairGroup& group : now.contacts.groups()) {
    if (group.runs.empty()) continue;
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q)
      add_pair(
          now, walls, group, q, ListedPairs::touching, [](std::uint32_t place) { return place; }, list);
  }
  return list;
}

}  // namespace scree
