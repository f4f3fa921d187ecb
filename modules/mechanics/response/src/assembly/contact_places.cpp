#include "assembly/contact_places.hpp"

#include <scree/surface_place.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::response {

PairAtRest ContactPlaces::pair(std::size_t contact) const {
  const Particles& p = simulation_.particles();
  PairAtRest pair(p, list_.a[contact], list_.b[contact]);
  pair.distance = pair.radius_a + pair.radius_b - list_.overlap[contact];
  for (int k = 0; k < 3; ++k) pair.normal[k] = list_.normal[3 * contact + std::size_t(k)];
  const std::size_t planes = simulation_.planes().size();
  if (!pair.to_wall()) {
    pair.separation = pair.distance * pair.normal;
    pair.change = PairVariation::of_bodies(pair.normal, pair.distance);
  } else if (pair.b - p.size() < planes) {
    pair.separation = from_plane(pair);
  } else {
    const BodyAtSurface body = at_surface(pair, pair.b - p.size() - planes);
    pair.set_at_surface(place_towards(simulation_.surfaces(), body, pair.direction()), body.from_origin);
    pair.crossed = crossed_by(pair.a) + simulation_.domain().beyond(position_of(pair.a));
  }
  return pair;
}

Vec3 ContactPlaces::place_of(std::uint32_t body) const {
  const Vec3 x = position_of(body);
  return x - simulation_.domain().beyond(x);
}

Vec3 ContactPlaces::position_of(std::uint32_t body) const {
  Vec3 x = {};
  for (int k = 0; k < simulation_.dimension(); ++k) x[k] = simulation_.particles().position()[k][body];
  return x;
}

Vec3 ContactPlaces::crossed_by(std::uint32_t body) const {
  const Domain& domain = simulation_.domain();
  Vec3 crossed = {};
  for (int k = 0; k < simulation_.dimension(); ++k)
    if (domain.periodic[std::size_t(k)])
      crossed[k] = domain.length(k) * simulation_.particles().image[k][body];
  return crossed;
}

// As SCREE_SEPARATION.
Vec3 ContactPlaces::from_plane(const PairAtRest& pair) const {
  const Particles& p = simulation_.particles();
  Vec3 from = crossed_by(pair.a);
  for (int k = 0; k < p.dimension(); ++k)
    from[k] = p.position()[k][pair.a] - simulation_.planes()[pair.b - p.size()].point[k] + from[k];
  return from;
}

// Surfaces have no periodic images.
BodyAtSurface ContactPlaces::at_surface(const PairAtRest& pair, std::size_t surface) const {
  const Vec3 inside = place_of(pair.a);
  BodyAtSurface body = {surface, simulation_.dimension(), {}, pair.radius_a};
  for (int k = 0; k < simulation_.dimension(); ++k)
    body.from_origin[k] = inside[k] - simulation_.surfaces().frames[surface].position[k];
  return body;
}

}  // namespace scree::response
