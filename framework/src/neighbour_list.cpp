#include <algorithm>
#include <cmath>

#include <scree/neighbour_list.hpp>

namespace scree {

namespace {

void wrap(Particles& p, const Domain& domain) {
  for (int k = 0; k < p.dimension(); ++k) {
    if (!domain.periodic[k]) continue;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double turns = std::floor((p.position[k][i] - domain.lower[k]) / domain.length(k));
      p.position[k][i] -= turns * domain.length(k);
      p.image[k][i] += std::int32_t(turns);
    }
  }
}

// Distance of a body's centre from a plane, positive on the material's side (m).
double height(const Particles& p, std::size_t i, const scree_plane& plane) {
  double h = 0;
  for (int k = 0; k < p.dimension(); ++k) h += (p.position[k][i] - plane.point[k]) * plane.normal[k];
  return h;
}

std::vector<PlanePair> near_planes(const Particles& p, const std::vector<scree_plane>& planes, double skin) {
  std::vector<PlanePair> pairs;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (std::uint32_t w = 0; w < planes.size(); ++w)
      if (height(p, i, planes[w]) < p.radius[i] + skin) pairs.push_back({i, w});
  return pairs;
}

}  // namespace

void NeighbourList::update(double body_speed, double plane_speed, double step, Particles& particles,
                           const Boundaries& boundaries, Contacts& contacts) {
  travelled_ += body_speed * step;
  planes_travelled_ += plane_speed * step;
  // The sum of largest speeds overestimates; measure before paying for a search.
  if (exhausted()) measure(particles, boundaries);
  if (exhausted()) rebuild(particles, boundaries, contacts);
}

void NeighbourList::measure(const Particles& p, const Boundaries& boundaries) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double square = 0;
    for (int k = 0; k < p.dimension(); ++k) {
      const double moved = p.position[k][i] - searched_position_[k][i];
      square += moved * moved;
    }
    largest = std::max(largest, square);
  }
  travelled_ = std::sqrt(largest);
  planes_travelled_ = 0;
  for (std::size_t w = 0; w < searched_planes_.size(); ++w) {
    double moved = 0;
    const scree_plane &now = boundaries.planes()[w], &then = searched_planes_[w];
    for (int k = 0; k < p.dimension(); ++k) moved += (now.point[k] - then.point[k]) * then.normal[k];
    planes_travelled_ = std::max(planes_travelled_, std::abs(moved));
  }
}

void NeighbourList::rebuild(Particles& particles, const Boundaries& boundaries, Contacts& contacts) {
  wrap(particles, boundaries.domain());
  Contacts::Lookup lookup = lookup_;
  lookup.body_material = particles.material.data();
  lookup.plane_material = boundaries.plane_materials().data();
  contacts.rebuild(find_neighbours(particles, boundaries.domain(), skin_),
                   near_planes(particles, boundaries.planes(), skin_), lookup);
  for (int k = 0; k < particles.dimension(); ++k) searched_position_[k] = particles.position[k];
  searched_planes_ = boundaries.planes();
  travelled_ = planes_travelled_ = 0;
  ++rebuilds_;
}

}  // namespace scree
