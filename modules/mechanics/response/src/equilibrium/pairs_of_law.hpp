#pragma once

#include "assembly/entries.hpp"
#include "equilibrium/pair_place.hpp"
#include "equilibrium/static_configuration.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include <scree/contact_columns.hpp>
#include <scree/contact_jacobian.hpp>
#include <scree/resting_packing.hpp>

namespace scree::response {

// Force (N) and torque (N m) on each body, then on each wall.
struct StaticLoads {
  std::vector<Vec3> force, torque;
};

// The pairs of one law in StaticContacts with bodies and planes, or with surfaces, with their histories.
class PairsOfLaw {
 public:
  using Partner = ContactColumns::Partner;
  // law: number in the scene; spins: as StaticContacts.
  PairsOfLaw(const Simulation& simulation, std::uint32_t law, Partner partner, int spins);

  // Sorted by (a, b). Pairs that were listed before keep their histories; new ones begin without.
  // gap: (m) within which they were looked for.
  void set_pairs(std::vector<StaticPair> pairs, double gap);
  // normal: of the contact, by which spots are told apart.
  void set_history(std::uint32_t a, std::uint32_t b, const Vec3& normal, const std::vector<double>& history,
                   bool sliding);
  // These three: see StaticContacts.
  void evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads);
  void add_stiffness(Entries& stiffness);
  void commit();

  std::uint32_t width() const { return law_.instance().history_width; }  // numbers in a history
  // States in the order of the pairs, at the beginning of the increment and after the last evaluation.
  const std::vector<PairState>& states_before() const { return states_; }
  const std::vector<PairState>& states_after() const { return next_states_; }
  double largest_force() const { return largest_force_; }
  // Marks the bodies, then the walls, that touch another in the last evaluation.
  void mark_touched(std::vector<bool>& touched) const;
  void append_touching(std::vector<ContactHistory>& all) const;

 private:
  bool touches(std::size_t i) { return columns_->input(SCREE_OVERLAP, 0, i) > 0; }
  PairState state_of(std::size_t i);
  // The pair before the increment that a new one goes on from, among those from `first` on, if there is one.
  std::optional<std::size_t> former(const StaticPair& pair, std::size_t first) const;
  // The first pair behind `begin` that is not of the same body and mesh.
  std::size_t end_of_spots(std::size_t begin) const;
  void add_places(std::size_t begin, std::size_t end, const StaticConfiguration& after,
                  const StaticMotion& motion);
  // Normal of a spot in the scene.
  Vec3 normal_of(const StaticPair& pair) const;
  // The history at the beginning of the increment; on a mesh its spring has turned with the spot.
  void fill_history(std::size_t i);
  void fill(std::size_t i, const PairPlace& at, const StaticConfiguration& after, const StaticMotion& motion);
  void add_loads(std::size_t i, StaticLoads& loads);

  const Simulation& simulation_;
  Partner partner_;
  ConfiguredLaw law_;
  ContactJacobian jacobian_;
  int spins_;
  std::vector<StaticPair> pairs_;
  std::vector<double> history_, next_history_;  // (pairs, width)
  std::vector<PairState> states_, next_states_;
  // From the last evaluation.
  std::optional<ContactColumns> columns_;
  std::vector<PairPlace> places_;
  std::vector<ContactGeometry> geometries_;
  double largest_force_ = 0;  // (N)
  double gap_ = 0;            // (m) up to which pairs are listed
};

}  // namespace scree::response
