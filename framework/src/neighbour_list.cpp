#include <algorithm>
#include <cmath>
#include <utility>

#include <scree/neighbour_list.hpp>

namespace scree {

namespace {

void wrap(Particles& p, const Domain& domain) {
  for (int k = 0; k < p.dimension(); ++k) {
    if (!domain.periodic[k]) continue;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.position()[k][i] >= domain.lower[k] && p.position()[k][i] < domain.upper[k]) continue;
      const double turns = std::floor((p.position()[k][i] - domain.lower[k]) / domain.length(k));
      p.position()[k][i] -= turns * domain.length(k);
      p.image[k][i] += std::int32_t(turns);
    }
  }
}

// Distance of a body's centre from a plane, positive on the material's side (m).
double height(const Particles& p, std::size_t i, const scree_plane& plane) {
  double h = 0;
  for (int k = 0; k < p.dimension(); ++k) h += (p.position()[k][i] - plane.point[k]) * plane.normal[k];
  return h;
}

// Pairs of bodies, and how many of them touch, told from a few thousand of them.
std::pair<double, double> count_pairs(const Particles& p, const Contacts& contacts, const Domain& domain) {
  constexpr std::size_t most_samples = 2500;
  double listed = 0, touching = 0;
  for (const PairGroup& group : contacts.groups()) {
    if (group.planes) continue;
    const std::size_t pairs = group.end - group.begin, stride = 1 + pairs / most_samples;
    listed += double(pairs);
    for (std::size_t q = group.begin; q < group.end; q += stride) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      const Vec3 shift = domain.shift(contacts.image[q]);
      const double reach = p.radius()[a] + p.radius()[b];
      double square = 0;
      for (int k = 0; k < p.dimension(); ++k) {
        const double apart = p.position()[k][a] - p.position()[k][b] + shift[k];
        square += apart * apart;
      }
      touching += square < reach * reach ? double(std::min(stride, group.end - q)) : 0;
    }
  }
  return {listed, touching};
}

std::vector<PlanePair> near_planes(const Particles& p, const std::vector<scree_plane>& planes, double skin) {
  std::vector<PlanePair> pairs;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (std::uint32_t w = 0; w < planes.size(); ++w)
      if (height(p, i, planes[w]) < p.radius()[i] + skin) pairs.push_back({i, w});
  return pairs;
}

}  // namespace

void NeighbourList::update(double body_speed, double plane_speed, double step, Particles& particles,
                           const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads) {
  travelled_ += body_speed * step;
  planes_travelled_ += plane_speed * step;
  // The sum of largest speeds overestimates; measure before paying for a search.
  ++steps_;
  const bool review = choice_.due(steps_);
  if (review || exhausted()) measure(particles, boundaries);
  const bool search = exhausted();
  if (!review && !search) return;
  if (!choice_.fixed()) {
    const SkinChoice::Experience list = experience(particles, boundaries, contacts);
    const double skin = search ? choice_.after(list) : choice_.review(list);
    if (!search && skin == skin_) return;
    skin_ = skin;
  }
  rebuild(particles, boundaries, contacts, threads);
}

SkinChoice::Experience NeighbourList::experience(const Particles& particles, const Boundaries& boundaries,
                                                 const Contacts& contacts) const {
  const auto [listed, touching] = count_pairs(particles, contacts, boundaries.domain());
  const double travelled = std::max(travelled_, planes_travelled_);
  return {skin_, travelled, steps_, listed, touching, double(particles.size())};
}

void NeighbourList::measure(const Particles& p, const Boundaries& boundaries) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double square = 0;
    for (int k = 0; k < p.dimension(); ++k) {
      const double moved = p.position()[k][i] - searched_position_[k][i];
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

void NeighbourList::rebuild(Particles& particles, const Boundaries& boundaries, Contacts& contacts,
                            ThreadPool& threads) {
  wrap(particles, boundaries.domain());
  Contacts::Lookup lookup = lookup_;
  lookup.body_material = particles.material.data();
  lookup.plane_material = boundaries.plane_materials().data();
  contacts.rebuild(search_.find(particles, boundaries.domain(), skin_, threads),
                   near_planes(particles, boundaries.planes(), skin_), lookup);
  for (int k = 0; k < particles.dimension(); ++k) {
    const auto x = particles.position()[k];
    searched_position_[k].assign(x.begin(), x.end());
  }
  searched_planes_ = boundaries.planes();
  travelled_ = planes_travelled_ = 0;
  steps_ = 0;
  ++rebuilds_;
}

}  // namespace scree
