#include "plugins/body_forces.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

scree_column from(Strided<const double> column, std::size_t body) {
  if (column.empty()) return {nullptr, 0};
  return {column.data() + body * column.stride(), column.stride()};
}
scree_column from(const BodyColumn<double>& column, std::size_t body) {
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
    members_.push_back({entry, ConfiguredBodyForce(entry.parameters, dimension, no_bounds, no_bounds)});
}

void BodyForces::apply(Times times, Particles& p, const Domain& domain, BodyRange bodies,
                       BodySums& sums) const {
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
  apply(times, batch);
  sums.potential += batch.potential;
  sums.dissipation_rate_translation += batch.dissipation_rate_translation;
  sums.dissipation_rate_rotation += batch.dissipation_rate_rotation;
  sums.work += batch.work;
}

void BodyForces::apply(Times times, scree_body_batch& batch) const {
  for (const Member& member : members_) {
    if (member.absent()) continue;
    batch.time = member.clock.at(times.now);
    batch.time_before = member.clock.at(times.before);
    member.plugin.interface().apply(member.plugin.storage(), &batch);
  }
}

double BodyForces::largest_damping_rate(const std::vector<Body>& bodies) const {
  double largest = 0;
  for (const Member& member : members_)
    if (const auto rate = member.plugin.interface().damping_rate; rate && !member.absent())
      for (const Body& b : bodies)
        if (!b.fixed) largest = std::max(largest, rate(member.plugin.storage(), b.mass, b.inertia, b.radius));
  return largest;
}

void BodyForces::configure(Member& member) const {
  member.plugin =
      ConfiguredBodyForce(member.clock.shown(member.entry.parameters), dimension_, no_bounds, no_bounds);
}

void BodyForces::reconfigure(const std::string& name, const Parameters& parameters, double time,
                             const std::vector<std::string>& going_on) {
  for (Member& member : members_)
    if (member.entry.name == name) {
      member.entry.parameters = parameters;
      member.clock.restart(time, going_on);
      return configure(member);
    }
  throw Error(fmt::format("no body force '{}'", name));
}

void BodyForces::begin_anew() {
  for (Member& member : members_) {
    const bool others = std::exchange(member.clock, {}).shows_others();
    if (others) configure(member);
  }
}

void BodyForces::transfer(const StateTransfer& state) {
  for (std::size_t k = 0; k < members_.size(); ++k) {
    Member& member = members_[k];
    const StateTransfer of_member = state.below(std::to_string(k));
    member.clock.transfer(of_member);
    if (state.restoring() && member.clock.shows_others()) configure(member);
  }
}

}  // namespace scree
