#include "contacts/start_springs.hpp"

#include <algorithm>
#include <utility>

#include <scree/plugin_host.hpp>

namespace scree {

namespace {

Vec3 normal_of(const ContactList& list, std::size_t contact) {
  return {list.normal[3 * contact], list.normal[3 * contact + 1], list.normal[3 * contact + 2]};
}

// Touching pairs by their bodies, sorted.
std::vector<std::size_t> sorted_by_bodies(const ContactList& list) {
  std::vector<std::size_t> order(list.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    return std::pair(list.a[i], list.b[i]) < std::pair(list.a[k], list.b[k]);
  });
  return order;
}

}  // namespace

StartSprings place_springs(const std::vector<Scene::Spring>& springs, const ContactList& touching,
                           const std::vector<LawInstance>& laws, int dimension, Contacts& contacts,
                           const BodyOrder& order) {
  StartSprings result;
  const std::vector<std::size_t> sorted = sorted_by_bodies(touching);
  for (const Scene::Spring& spring : springs) {
    // In the list of contacts, a is the first of two bodies.
    const auto [first, second] = std::minmax(spring.a, spring.b);
    const auto place =
        std::lower_bound(sorted.begin(), sorted.end(), std::pair(first, second),
                         [&](std::size_t k, const std::pair<std::uint32_t, std::uint32_t>& bodies) {
                           return std::pair(touching.a[k], touching.b[k]) < bodies;
                         });
    const bool touch = place != sorted.end() && touching.a[*place] == first && touching.b[*place] == second;
    if (!touch) {
      ++result.apart;
      continue;
    }
    if (!keeps_spring(laws[touching.law[*place]].interface, dimension)) {
      ++result.without_room;
      continue;
    }
    const Vec3 normal = normal_of(touching, *place);
    const Vec3 along = spring.a == first ? spring.displacement : -1.0 * spring.displacement;
    const Vec3 tangential = along - dot(along, normal) * normal;
    const auto [group, row] = contacts.find(false, first, second, order);
    for (int k = 0; k < dimension; ++k) group->history.column(std::uint32_t(k))[row] = tangential[k];
    ++result.placed;
  }
  return result;
}

}  // namespace scree
