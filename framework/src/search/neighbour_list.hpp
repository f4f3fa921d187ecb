#pragma once

#include "contacts/contacts.hpp"
#include "plugins/boundaries.hpp"
#include "search/skin_choice.hpp"

#include <cstdint>
#include <vector>

#include <scree/particles.hpp>

namespace scree {

// Decides when contacts must be searched anew, and does it.
// Pairs are listed while their surfaces are nearer than the skin; none can touch unlisted as long as the two
// displacements since the search add up to less than the skin.
class NeighbourList {
 public:
  // The skin may become as thick as `max_skin` where that is cheaper (m); 0 keeps it.
  NeighbourList(double skin, double max_skin, Contacts::Lookup lookup)
      : skin_(skin), choice_(skin, max_skin), lookup_(lookup) {}

  // Advances the displacement bound by one step at these largest speeds (m/s), and searches if it ran out.
  void update(double body_speed, double plane_speed, double step, Particles& particles,
              const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads);
  // Searches now; bodies that left a periodic domain come in again at the other side.
  void rebuild(Particles& particles, const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads);

  double skin() const { return skin_; }
  double first_skin() const { return choice_.first(); }
  std::uint64_t rebuilds() const { return rebuilds_; }

 private:
  bool exhausted() const { return body_travel_ + std::max(body_travel_, plane_travel_) >= skin_; }
  void record_positions(Particles& particles, const Domain& domain);
  void measure(const Particles& particles, const Boundaries& boundaries);
  SkinChoice::ListStatistics list_statistics(const Particles& particles, const Boundaries& boundaries,
                                             const Contacts& contacts) const;

  double skin_;
  SkinChoice choice_;
  std::uint64_t steps_ = 0;  // since the search
  Contacts::Lookup lookup_;
  NeighbourSearch search_;
  double body_travel_ = 0, plane_travel_ = 0;  // (m) upper bounds since the search
  Column<Sphere> searched_;                    // bodies at the search
  std::vector<scree_plane> searched_planes_;
  std::uint64_t rebuilds_ = 0;
};

}  // namespace scree
