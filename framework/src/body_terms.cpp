#include <algorithm>

#include <fmt/format.h>

#include <scree/body_terms.hpp>
#include <scree/error.hpp>

namespace scree {

namespace {

constexpr double nowhere[3] = {0, 0, 0};

double* data_or_null(Column<double>& column) { return column.empty() ? nullptr : column.data(); }

}  // namespace

BodyTerms::BodyTerms(const std::vector<Entry>& entries, int dimension) : dimension_(dimension) {
  for (const Entry& entry : entries)
    members_.push_back({entry.name, ConfiguredBodyTerm(entry.parameters, dimension, nowhere, nowhere)});
}

BodySums BodyTerms::apply(Particles& p, const Domain& domain) const {
  scree_body_batch batch = {};
  batch.struct_size = sizeof(batch);
  batch.dimension = std::uint32_t(dimension_);
  batch.count = std::uint32_t(p.size());
  for (int k = 0; k < 3; ++k) {
    batch.position[k] = data_or_null(p.position[k]);
    batch.velocity[k] = data_or_null(p.velocity[k]);
    batch.spin[k] = data_or_null(p.spin[k]);
    batch.force[k] = data_or_null(p.force[k]);
    batch.torque[k] = data_or_null(p.torque[k]);
    if (!domain.periodic[std::size_t(k)] || p.image[k].empty()) continue;
    batch.image[k] = p.image[k].data();
    batch.period[k] = domain.length(k);
  }
  batch.radius = p.radius.data();
  batch.mass = p.mass.data();
  batch.inertia = data_or_null(p.inertia);
  for (const Member& member : members_) member.plugin.interface().apply(member.plugin.storage(), &batch);
  return {batch.potential, batch.dissipated_translation, batch.dissipated_rotation};
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
