#include "plugins/body_forces.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree {

namespace {

scree_column from(Strided<const double> column, std::size_t body) {
  if (column.empty()) return {nullptr, 0};
  return {column.data() + body * column.stride(), column.stride()};
}
scree_column from(const Column<double>& column, std::size_t body) {
  return from(Strided<const double>(column.data(), 1, column.size()), body);
}
scree_load_column loads_from(Strided<double> column, std::size_t body) {
  if (column.empty()) return {nullptr, 0};
  return {column.data() + body * column.stride(), column.stride()};
}

}  // namespace

BodyForces::BodyForces(const std::vector<Scene::BodyForce>& entries, int dimension, bool audit)
    : dimension_(dimension), audit_(audit) {
  for (const Scene::BodyForce& entry : entries)
    members_.push_back({entry.name, ConfiguredBodyForce(entry.parameters, dimension, no_bounds, no_bounds)});
}

void BodyForces::apply(Particles& p, const Domain& domain, BodyRange bodies, BodySums& sums) const {
  if (members_.empty()) return;
  const std::size_t first = bodies.begin;
  scree_body_batch batch = {};
  batch.struct_size = sizeof(batch);
  batch.dimension = std::uint32_t(dimension_);
  batch.count = std::uint32_t(bodies.end - first);
  batch.audit = audit_;
  for (int k = 0; k < 3; ++k) {
    batch.position[k] = from(std::as_const(p).position()[k], first);
    batch.velocity[k] = from(std::as_const(p).velocity()[k], first);
    batch.spin[k] = from(std::as_const(p).spin()[k], first);
    batch.force[k] = loads_from(p.force()[k], first);
    batch.torque[k] = loads_from(p.torque()[k], first);
    if (!domain.periodic[std::size_t(k)] || p.image[k].empty()) continue;
    batch.image[k] = p.image[k].data() + first;
    batch.period[k] = domain.length(k);
  }
  batch.radius = from(p.radius(), first);
  batch.mass = from(p.mass, first);
  batch.inertia = from(p.inertia, first);
  for (const Member& member : members_) member.plugin.interface().apply(member.plugin.storage(), &batch);
  sums.potential += batch.potential;
  sums.dissipation_rate_translation += batch.dissipation_rate_translation;
  sums.dissipation_rate_rotation += batch.dissipation_rate_rotation;
}

double BodyForces::largest_damping_rate(const std::vector<Body>& bodies) const {
  double largest = 0;
  for (const Member& member : members_)
    if (const auto rate = member.plugin.interface().damping_rate)
      for (const Body& b : bodies)
        if (!b.fixed) largest = std::max(largest, rate(member.plugin.storage(), b.mass, b.inertia, b.radius));
  return largest;
}

void BodyForces::reconfigure(const std::string& name, const Parameters& parameters) {
  for (Member& member : members_)
    if (member.name == name) {
      member.plugin = ConfiguredBodyForce(parameters, dimension_, no_bounds, no_bounds);
      return;
    }
  throw Error(fmt::format("no body force '{}'", name));
}

}  // namespace scree
