#include "contacts/touching_contacts.hpp"

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

Meeting meeting_of(const Particles& p, const Contacts& contacts, bool with_plane, std::size_t pair,
                   const std::vector<scree_plane>& planes, const Domain& domain) {
  const std::uint32_t a = contacts.a[pair], b = contacts.b[pair];
  Vec3 normal = {};
  double distance = 0, reach = p.radius()[a];
  if (with_plane) {
    for (int k = 0; k < p.dimension(); ++k) normal[k] = planes[b].normal[k];
    for (int k = 0; k < p.dimension(); ++k) distance += (p.position()[k][a] - planes[b].point[k]) * normal[k];
  } else {
    normal = position(p, a) - position(p, b) + domain.shift(contacts.image[pair]);
    distance = norm(normal);
    normal = (distance > 0 ? 1 / distance : 0) * normal;
    reach += p.radius()[b];
  }
  return {normal, reach - distance};
}

}  // namespace

std::size_t count_touching(const Particles& p, const Contacts& contacts,
                           const std::vector<scree_plane>& planes, const Domain& domain) {
  std::size_t touching = 0;
  for (const PairGroup& group : contacts.groups())
    group.each_pair([&](std::size_t q) {
      touching += meeting_of(p, contacts, group.planes, q, planes, domain).overlap > 0;
    });
  return touching;
}

void count_contacts(const Particles& p, const Contacts& contacts, const std::vector<scree_plane>& planes,
                    const Domain& domain, BodyColumn<std::uint32_t>& counts) {
  for (const PairGroup& group : contacts.groups())
    group.each_pair([&](std::size_t q) {
      if (!(meeting_of(p, contacts, group.planes, q, planes, domain).overlap > 0)) return;
      ++counts[contacts.a[q]];
      if (!group.planes) ++counts[contacts.b[q]];
    });
}

namespace {

// Adds a pair to a list if it belongs there; number: which number of a body, given its place, the list has.
template <class Number>
void add_pair(const PairsNow& now, const PairGroup& group, std::size_t q, ListedPairs listed,
              const Number& number, ContactList& list) {
  const auto& [p, contacts, forces, laws, planes, domain] = now;
  const std::uint32_t a = contacts.a[q], b = contacts.b[q];
  const auto [normal, overlap] = meeting_of(p, contacts, group.planes, q, planes, domain);
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
  ContactList list;
  for (const PairGroup& group : now.contacts.groups())
    for (const std::size_t q : now.contacts.in_scene_order(group, order))
      add_pair(
          now, group, q, listed, [&](std::uint32_t place) { return order.number(place); }, list);
  return list;
}

ContactList touching_contacts_of(const PairsNow& now, std::size_t tile) {
  ContactList list;
  for (const PairGroup& group : now.contacts.groups()) {
    if (group.runs.empty()) continue;
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q)
      add_pair(
          now, group, q, ListedPairs::touching, [](std::uint32_t place) { return place; }, list);
  }
  return list;
}

}  // namespace scree
