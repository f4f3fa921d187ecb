#include "final_packing.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/packing/csv.hpp>

namespace scree::run {

namespace {

packing::Packing packing_of(const Simulation& s) {
  packing::Packing all;
  all.dimension = s.dimension();
  all.time = s.time();
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    all.bodies.push_back({.id = b.id,
                          .material = s.scene().materials[b.material],
                          .radius = b.radius,
                          .mass = b.mass,
                          .position = b.position,
                          .velocity = b.velocity,
                          .spin = b.spin});
  }
  // Sorted by id, as the order in memory is arbitrary.
  std::stable_sort(all.bodies.begin(), all.bodies.end(),
                   [](const packing::Body& a, const packing::Body& b) { return a.id < b.id; });
  return all;
}

// The periodic axes of the scene, around the bodies along the others.
void add_box(const Domain& domain, packing::Packing& all) {
  if (!domain.any_periodic()) return;
  all.periodic = domain.periodic;
  all.bounds = packing::enclosing_bounds(all);
  for (int k = 0; k < 3; ++k)
    if (domain.periodic[std::size_t(k)])
      all.bounds->lower[k] = domain.lower[k], all.bounds->upper[k] = domain.upper[k];
}

bool is_finite(const packing::Body& b) {
  return std::isfinite(norm(b.position)) && std::isfinite(norm(b.velocity)) && std::isfinite(norm(b.spin));
}

}  // namespace

void write_final_packing(const Simulation& simulation, const std::filesystem::path& path) {
  packing::Packing last = packing_of(simulation);
  for (const packing::Body& body : last.bodies)
    if (!is_finite(body))
      throw Error(
          fmt::format(
              "particle {}: position, velocity or spin at t = {:g} s is beyond the range of numbers, so "
              "that final_packing.csv is not written; use a shorter time.step or a shorter run",
              body.id, simulation.time()),
          ExitStatus::failure);
  add_box(simulation.domain(), last);
  packing::write_csv(last, path);
}

}  // namespace scree::run
