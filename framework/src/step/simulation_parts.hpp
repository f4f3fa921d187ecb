#pragma once

#include "audit/energy_audit.hpp"
#include "audit/momentum_audit.hpp"
#include "bodies/body_facts.hpp"
#include "contacts/contacts.hpp"
#include "contacts/displaced_loads.hpp"
#include "contacts/forces.hpp"
#include "contacts/touching_contacts.hpp"
#include "motion/driven_bodies.hpp"
#include "motion/integrator.hpp"
#include "plugins/body_forces.hpp"
#include "ranks/rank_commands.hpp"
#include "ranks/rank_share.hpp"
#include "ranks/row_routes.hpp"
#include "search/neighbour_list.hpp"
#include "step/stepper.hpp"
#include "walls/boundaries.hpp"

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>
#include <scree/resting_packing.hpp>
#include <scree/scene.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

// The parts of a simulation, in the order in which they are constructed.
struct SimulationParts {
  // Throws Error for an invalid scene. Evaluates no forces.
  explicit SimulationParts(Scene scene);
  // Of a scene without its bodies, which come from another rank; see transfer_shared.
  SimulationParts(Scene&& scene, const BodyFacts& bodies);

  // Configures the laws of the scene again. Throws Error if a law needs what the scene does not carry.
  void configure_laws();
  // All that changes in a run.
  void transfer(const class StateTransfer& state);
  // The two halves of it: the pairs follow the bodies and walls when restoring, and have no order when
  // saving.
  void transfer_all_but_pairs(const class StateTransfer& state);
  void transfer_pairs(const class StateTransfer& state);
  // The sums of contacts in a state.
  static ContactSums contact_sums_in(const State& state);
  // Moves bodies, walls and contacts to their places in a packing at rest.
  void come_to_rest(const RestingPacking& packing);
  void search_neighbours();
  // For a simulation without pairs: the first search and evaluation.
  void find_and_evaluate_pairs();
  void transfer_order(const class StateTransfer& bodies);
  // Moves the bodies in memory, see Particles::rearrange; a search must follow.
  void rearrange(const std::vector<std::uint32_t>& from);
  // Places of bodies that this process moves: all, or of the tiles of this rank.
  std::vector<BodyRange> own_places() const;
  // Sorts the bodies in space if a search has found that many neighbours are distant in memory.
  void keep_neighbours_near() {
    if (!neighbours.better_order().empty()) sort_bodies();
    if (share && share->dealt_after != neighbours.rebuilds()) deal_after_search();
  }
  void sort_bodies();
  // What all ranks have, of all that changes in a run: no bodies and no pairs.
  void transfer_common(const class StateTransfer& state);
  // And of that the first rank has, where bodies are in memory and what the lists of neighbours need.
  void transfer_shared(const class StateTransfer& state);
  // From now on several ranks compute the scene, of which the first has all bodies and pairs.
  void share_with(Ranks& ranks);
  // Tiles for each rank with about as much work, where the work of a tile is the number of its pairs and
  // bodies times the `weight` of its present rank.
  TileOwners balanced_owners(double weight) const;
  // Gives tiles to other ranks, with their bodies and pairs.
  void deal_tiles(TileOwners next);
  void deal_after_search();
  // Gives tiles to other ranks if bodies alone have been counted and pairs ask for it.
  void deal_by_pairs();
  // Of the pairs and bodies of this rank.
  double own_work() const;
  // What all ranks have of something: the largest, and the mean.
  struct Load {
    double most, mean;
  };
  Load load_of_ranks(double own) const;
  void send_bodies(const RowRoutes& routes);
  void send_bodies_for_good(const RowRoutes& routes);  // with what is constant
  // Give the first rank the state of all bodies, all pairs.
  void gather_bodies();
  // Of bodies of these numbers, which other ranks get from the first rank.
  void gather_listed(const std::vector<std::uint32_t>& numbers);
  void gather_pairs();
  // What friction has dissipated on surfaces.
  void gather_sliding_work();
  // Listed pairs of all ranks, of these the pairs of bodies; see Footprint.
  struct PairCounts {
    std::size_t listed, touching, bytes_per_pair;
    CrossingPairs of_bodies;
    std::size_t foreign_bodies, bytes_sent;
  };
  PairCounts count_pairs();
  // Has the other ranks add up the totals of a probe; the first time, tells them what it is.
  void command_totals(const class Probe& probe);
  void command_change(RankCommand command, const std::string& name, const Parameters& parameters,
                      const std::vector<std::string>& going_on) const;
  // Has the other ranks do something, if this is the first of several.
  void command(RankCommand command, const std::vector<std::string>& lines = {}) const {
    if (share && share->is_first()) send_command(share->ranks, command, lines);
  }
  // The state of all bodies, by place or in the order of the scene: see Particles::order().
  Particles& all_bodies();
  // The bodies in the order of the scene: a copy if they are rearranged, valid until something moves them.
  Particles& in_scene_order();
  // The same if only bodies of these numbers are read, but for constants of others: costs less.
  Particles& in_scene_order(const std::vector<std::uint32_t>& numbers);
  // What laws keep of all pairs, for the first rank.
  void add_histories(class StateHash& hash);
  // See Simulation.
  void check_returning_walls(const std::string& name, const Parameters& parameters,
                             const std::vector<std::string>& going_on);
  // Throws Error if a wall that was absent at the last search has bodies behind it.
  void check_appeared_walls();

  // Null if this process computes the whole scene.
  Ranks* ranks() const { return share ? &share->ranks : nullptr; }

  Scene scene;
  BodyFacts facts;                 // of the bodies at the start
  std::optional<RankShare> share;  // if several ranks compute the scene
  std::vector<ConfiguredLaw> configured_laws;
  std::vector<LawInstance> laws;
  Boundaries boundaries;
  BodyForces body_forces;
  Particles particles;  // by place
  DrivenBodies driven;
  std::vector<std::uint32_t> law_of;  // of the scene, without the laws that are absent
  Contacts contacts;
  NeighbourList neighbours;
  Forces forces;
  std::optional<DisplacedLoads> displaced_loads;  // once a boundary asks for loads after displacements
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<ThreadPool> threads;
  Profile* profile = nullptr;

  ContactSums contact_sums;  // of the last evaluation
  BodySums body_sums;
  EnergyAudit audit;
  MomentumAudit momentum_audit;

  double speed_limit;                           // (m/s) above which the run is stopped as a blow-up
  Vec3 lengths_at_start;                        // (m) see Simulation::lengths
  std::vector<std::string> taken_over, let_go;  // see Simulation

  Stepper stepper;

  // The pairs of all ranks, and the forces of these, on the first rank.
  struct Pairs {
    Contacts& contacts;
    PairColumns& forces;
  };
  Pairs all_pairs();
  // After the state has changed: what was copied for observers is no longer current.
  void forget_copies() { copy_is_current = bodies_are_gathered = pairs_are_gathered = false; }

  std::optional<Particles> copy_in_scene_order;
  std::optional<Contacts> gathered_contacts;
  PairColumns gathered_forces;
  std::vector<std::uint32_t> listed_bodies;  // that have been gathered last
  std::set<std::uint64_t> sent_probes;       // that the other ranks know
  bool copy_is_current = false, bodies_are_gathered = false, pairs_are_gathered = false;
};

}  // namespace scree
