#include "equilibrium/static_contacts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/surface_place.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::response {

namespace {

// Numbers of the surfaces that exert forces.
std::vector<std::uint32_t> present_surfaces(const Simulation& simulation) {
  const WallSurfaces& surfaces = simulation.surfaces();
  std::vector<std::uint32_t> present;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    if (!simulation.absent_walls()[simulation.planes().size() + s]) present.push_back(s);
  return present;
}

}  // namespace

StaticContacts::StaticContacts(const Simulation& simulation, int spins) : simulation_(simulation) {
  for (const auto partner : {PairsOfLaw::Partner::body_or_plane, PairsOfLaw::Partner::surface})
    for (std::uint32_t law = 0; law < simulation.scene().laws.size(); ++law)
      laws_.push_back(std::make_unique<PairsOfLaw>(simulation, law, partner, spins));
  find_pairs(StaticConfiguration(simulation), 0);
  const ContactList list = simulation.contact_list();
  for (std::size_t c = 0; c < list.size(); ++c) {
    PairsOfLaw& law = *laws_[place_of(list.law[c], list.b[c])];
    std::vector<double> history;
    for (std::uint32_t k = 0; k < law.width(); ++k)
      history.push_back(simulation.contact_history(list.pair[c], k));
    const Vec3 normal = {{list.normal[3 * c], list.normal[3 * c + 1], list.normal[3 * c + 2]}};
    law.set_history(list.a[c], list.b[c], normal, history, list.sliding[c]);
  }
}

std::size_t StaticContacts::place_of(std::uint32_t law, std::uint32_t b) const {
  const bool surface = b >= simulation_.particles().size() + simulation_.planes().size();
  return law + (surface ? simulation_.scene().laws.size() : 0);
}

std::vector<Sphere> StaticContacts::spheres(const StaticConfiguration& at) const {
  const Particles& p = simulation_.particles();
  const Domain& domain = simulation_.domain();
  std::vector<Sphere> all;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3 x = at.position[i];
    for (int k = 0; k < p.dimension(); ++k)
      if (domain.periodic[std::size_t(k)])
        x[k] -= std::floor((x[k] - domain.lower[k]) / domain.length(k)) * domain.length(k);
    all.push_back({x, p.radius()[i]});
  }
  return all;
}

void StaticContacts::find_pairs(const StaticConfiguration& at, double gap) {
  const Particles& p = simulation_.particles();
  const Domain& domain = simulation_.domain();
  const std::size_t materials = simulation_.scene().materials.size();
  std::vector<std::vector<StaticPair>> pairs(laws_.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t material_b, const Vec3& shift,
                       const std::optional<SurfaceSpot>& spot = std::nullopt) {
    const std::uint32_t law = simulation_.scene().law_of[p.material[a] * materials + material_b];
    if (simulation_.scene().laws[law].parameters.absent()) return;
    pairs[place_of(law, b)].push_back({a, b, shift, spot});
  };
  const std::vector<Sphere> wrapped = spheres(at);
  const std::vector<std::uint32_t> surfaces = present_surfaces(simulation_);
  const std::vector<NeighbourPair>& near = search_.find(wrapped, p.dimension(), domain, gap, threads_);
  auto next = near.begin();
  for (std::uint32_t a = 0; a < p.size(); ++a) {
    for (; next != near.end() && next->a == a; ++next) {
      if (p.is_fixed(a) && p.is_fixed(next->b)) continue;  // they exert no force on each other
      const Vec3 apart = at.position[a] - at.position[next->b];
      Vec3 shift = {};
      for (int k = 0; k < p.dimension(); ++k)
        if (domain.periodic[std::size_t(k)])
          shift[k] = -std::round(apart[k] / domain.length(k)) * domain.length(k);
      add(a, next->b, p.material[next->b], shift);
    }
    for (std::size_t w = 0; w < simulation_.planes().size(); ++w) {
      if (simulation_.absent_walls()[w]) continue;
      const auto b = std::uint32_t(p.size() + w);
      const Vec3 apart = at.position[a] - at.position[b];
      double distance = 0;
      for (int k = 0; k < p.dimension(); ++k) distance += apart[k] * simulation_.planes()[w].normal[k];
      if (distance <= p.radius()[a] + gap) add(a, b, simulation_.plane_materials()[w], {});
    }
    for (const std::uint32_t s : surfaces) {
      const auto b = std::uint32_t(p.size() + simulation_.planes().size() + s);
      // Surfaces have no periodic images.
      const Vec3 shift = wrapped[a].position - at.position[a];
      const Vec3 from_origin = at.position[a] - at.position[b] + shift;
      const BodyAtSurface body = {s, p.dimension(), from_origin, p.radius()[a]};
      const std::uint32_t material = simulation_.surfaces().materials[s];
      if (simulation_.surfaces().meshes[s]) {
        for (const SurfaceSpot& spot : spots_within(simulation_.surfaces(), body, p.radius()[a] + gap))
          add(a, b, material, shift, spot);
        continue;
      }
      const SurfacePlace place = nearest_place(simulation_.surfaces(), body);
      if (place.direction.distance <= p.radius()[a] + gap) add(a, b, material, shift);
    }
  }
  for (std::size_t law = 0; law < laws_.size(); ++law) laws_[law]->set_pairs(std::move(pairs[law]), gap);
}

void StaticContacts::evaluate(const StaticConfiguration& after, const StaticMotion& motion,
                              StaticLoads& loads) {
  for (const auto& law : laws_) law->evaluate(after, motion, loads);
}

void StaticContacts::add_stiffness(Entries& stiffness) const {
  for (const auto& law : laws_) law->add_stiffness(stiffness);
}

void StaticContacts::commit() {
  for (const auto& law : laws_) law->commit();
}

std::vector<PairState> StaticContacts::states(StatesOfLaw states_of) const {
  std::vector<PairState> all;
  for (const auto& law : laws_) {
    const std::vector<PairState>& some = ((*law).*states_of)();
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::size_t StaticContacts::events() const {
  const std::vector<PairState> before = states_before(), after = states_after();
  std::size_t changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) changed += before[i].status != after[i].status;
  return changed;
}

std::size_t StaticContacts::count(PairStatus status) const {
  const std::vector<PairState> all = states_before();
  return std::size_t(
      std::count_if(all.begin(), all.end(), [&](const auto& p) { return p.status == status; }));
}

std::vector<bool> StaticContacts::touched() const {
  std::vector<bool> touched(simulation_.particles().size() + simulation_.planes().size() +
                            simulation_.surfaces().size());
  for (const auto& law : laws_) law->mark_touched(touched);
  return touched;
}

double StaticContacts::largest_force() const {
  double largest = 0;
  for (const auto& law : laws_) largest = std::max(largest, law->largest_force());
  return largest;
}

std::vector<ContactHistory> StaticContacts::touching() const {
  std::vector<ContactHistory> all;
  for (const auto& law : laws_) law->append_touching(all);
  return all;
}

}  // namespace scree::response
