#include "close_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/pair_search.hpp>

namespace scree::packing {

namespace {

// Over the smallest radius: more than the round-off of positions that are folded into the domain. Distances
// decide.
constexpr double search_margin = 1e-6;

Domain domain_of(const Packing& packing) {
  Domain domain;
  for (int k = 0; k < 3; ++k) {
    if (!packing.periodic[k]) continue;
    domain.periodic[k] = true;
    domain.lower[k] = packing.bounds->lower[k];
    domain.upper[k] = packing.bounds->upper[k];
  }
  return domain;
}

std::vector<Sphere> spheres_of(const Packing& packing, const Domain& domain) {
  std::vector<Sphere> spheres;
  spheres.reserve(packing.bodies.size());
  for (const Body& body : packing.bodies) {
    Sphere sphere = {{}, body.radius};
    for (int k = 0; k < packing.dimension; ++k) {
      sphere.position[k] = body.position[k];
      if (domain.periodic[k])
        sphere.position[k] -=
            std::floor((body.position[k] - domain.lower[k]) / domain.length(k)) * domain.length(k);
    }
    spheres.push_back(sphere);
  }
  return spheres;
}

double distance(const Packing& packing, const Domain& domain, std::size_t i, std::size_t j) {
  Vec3 d = packing.bodies[j].position - packing.bodies[i].position;
  for (int k = 0; k < packing.dimension; ++k)
    if (domain.periodic[k]) d[k] -= domain.length(k) * std::round(d[k] / domain.length(k));
  return std::hypot(d[0], d[1], d[2]);
}

// Returns false once visit() does.
bool visit_own_images(const Packing& packing, const Domain& domain,
                      const std::function<bool(const ClosePair&)>& visit) {
  for (int k = 0; k < packing.dimension; ++k) {
    if (!domain.periodic[k]) continue;
    const double length = domain.length(k);
    for (std::size_t i = 0; i < packing.bodies.size(); ++i)
      if (length < 2.0 * packing.bodies[i].radius && !visit({i, i, length})) return false;
  }
  return true;
}

}  // namespace

void visit_close_pairs(const Packing& packing, const std::function<bool(const ClosePair&)>& visit) {
  const Domain domain = domain_of(packing);
  if (!visit_own_images(packing, domain, visit)) return;
  const std::vector<Sphere> spheres = spheres_of(packing, domain);
  const auto smaller = [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; };
  const double smallest = std::min_element(spheres.begin(), spheres.end(), smaller)->radius;
  PairSearch(PairSearch::Images::nearest)
      .visit(spheres, packing.dimension, domain, search_margin * smallest, [&](const NeighbourPair& pair) {
        const double apart = distance(packing, domain, pair.a, pair.b);
        return !(apart < spheres[pair.a].radius + spheres[pair.b].radius) || visit({pair.a, pair.b, apart});
      });
}

}  // namespace scree::packing
