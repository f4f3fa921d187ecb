#include <algorithm>

#include <fmt/format.h>

#include <scree/body_terms.hpp>
#include <scree/error.hpp>

namespace scree {

namespace {

constexpr double nowhere[3] = {0, 0, 0};

double* from(Column<double>& column, std::size_t body) {
  return column.empty() ? nullptr : column.data() + body;
}

}  // namespace

BodyTerms::BodyTerms(const std::vector<Entry>& entries, int dimension) : dimension_(dimension) {
  for (const Entry& entry : entries)
    members_.push_back({entry.name, ConfiguredBodyTerm(entry.parameters, dimension, nowhere, nowhere)});
}

void BodyTerms::apply(Particles& p, const Domain& domain, BodyRange bodies, BodySums& sums) const {
  if (members_.empty()) return;
  const std::size_t first = bodies.begin;
  scree_body_batch batch = {};
  batch.struct_size = sizeof(batch);
  batch.dimension = std::uint32_t(dimension_);
  batch.count = std::uint32_t(bodies.end - first);
  for (int k = 0; k < 3; ++k) {
    batch.position[k] = from(p.position[k], first);
    batch.velocity[k] = from(p.velocity[k], first);
    batch.spin[k] = from(p.spin[k], first);
    batch.force[k] = from(p.force[k], first);
    batch.torque[k] = from(p.torque[k], first);
    if (!domain.periodic[std::size_t(k)] || p.image[k].empty()) continue;
    batch.image[k] = p.image[k].data() + first;
    batch.period[k] = domain.length(k);
  }
  batch.radius = p.radius.data() + first;
  batch.mass = p.mass.data() + first;
  batch.inertia = from(p.inertia, first);
  for (const Member& member : members_) member.plugin.interface().apply(member.plugin.storage(), &batch);
  sums.potential += batch.potential;
  sums.dissipated_translation += batch.dissipated_translation;
  sums.dissipated_rotation += batch.dissipated_rotation;
}

double BodyTerms::largest_damping_rate(const std::vector<Body>& bodies) const {
  double largest = 0;
  for (const Member& member : members_)
    if (const auto rate = member.plugin.interface().damping_rate)
      for (const Body& b : bodies)
        largest = std::max(largest, rate(member.plugin.storage(), b.mass, b.inertia, b.radius));
  return largest;
}

void BodyTerms::reconfigure(const std::string& name, const Parameters& parameters) {
  for (Member& member : members_)
    if (member.name == name) {
      member.plugin = ConfiguredBodyTerm(parameters, dimension_, nowhere, nowhere);
      return;
    }
  throw Error(fmt::format("no body term '{}'", name));
}

}  // namespace scree
