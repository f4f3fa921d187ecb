#pragma once

#include "contacts/contacts.hpp"
#include "ranks/bodies_near.hpp"
#include "ranks/rank_share.hpp"
#include "search/near_walls.hpp"
#include "search/repeated_search.hpp"
#include "search/skin_choice.hpp"
#include "walls/boundaries.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <scree/pair_search.hpp>
#include <scree/particles.hpp>

namespace scree {

// Verlet neighbour list: lists the pairs whose surfaces are nearer than the skin, and searches again when
// needed. No unlisted pair can touch as long as the largest two displacements since the search add up to less
// than the skin.
class NeighbourList {
 public:
  // skin: of the first search (m); it may grow to max_skin (m) if that costs less. max_skin = 0: fixed.
  NeighbourList(double skin, double max_skin, Contacts::Lookup lookup)
      : skin_(skin), choice_(skin, max_skin), lookup_(lookup) {}

  // From now on several ranks compute the scene: lists the pairs of the tiles of this rank alone.
  // bring_others: brings the bodies of other ranks that listed pairs have.
  void share_with_ranks(RankShare& share, std::size_t bodies, std::function<void()> bring_others) {
    share_ = &share;
    bodies_at_search_.resize(bodies);
    bring_others_ = std::move(bring_others);
  }

  // Adds one step (s) at these largest speeds (m/s) to the displacement bound; searches if that is too large.
  void update(double body_speed, double plane_speed, double surface_speed, double step, Particles& particles,
              const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads);
  // For planes that have not moved yet in a step in which bodies have moved by up to body_travel: searches
  // now unless no unlisted pair touches wherever the planes are within plane_reach (m).
  void extend(double body_travel, double plane_reach, Particles& particles, const Boundaries& boundaries,
              Contacts& contacts, ThreadPool& threads);
  // Searches now, wherever bodies and planes have been before, and folds positions into the periodic domain.
  void rebuild(Particles& particles, const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads);

  // All but the pairs; the skin of the first search follows from the scene.
  void transfer(const class StateTransfer& state, const Particles& particles, const Boundaries& boundaries);
  // The same without the bodies at the last search.
  void transfer_but_bodies(const class StateTransfer& state, const Particles& particles,
                           const Boundaries& boundaries);

  // The order in which bodies should be sorted again in memory, see spatial_order(); empty if they need not
  // be. Known after a search.
  const std::vector<std::uint32_t>& better_order() const { return better_order_; }
  // Sends bodies at the last search to other ranks.
  void send(const class RowRoutes& routes);
  // Moves the bodies in memory, see Particles::rearrange; a search must follow.
  void rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept);

  // After tiles have been dealt to ranks.
  void forget_near_bodies() {
    near_covered_ = 0;
    near_walls_.forget();
  }

  const std::vector<double>& surface_reach() const { return surface_reach_; }
  double skin() const { return skin_; }
  // Of each plane, whether it was absent at the last search.
  const std::vector<std::uint8_t>& absent_at_search() const { return absent_at_search_; }
  double first_skin() const { return choice_.first(); }
  std::uint64_t rebuilds() const { return rebuilds_; }

 private:
  bool skin_used_up() const { return used_up(body_travel_, wall_travel()); }
  // How far from the origin of each surface bodies may meet it before the next search (m).
  void measure_reach(const Boundaries& boundaries);
  double wall_travel() const { return std::max(plane_travel_, surface_travel_); }
  bool used_up(double body_travel, double plane_travel) const {
    return body_travel + std::max(body_travel, plane_travel) >= skin_;
  }
  // moved: bound of the displacement of any body since the last search (m).
  void search(double moved, Particles& particles, const Boundaries& boundaries, Contacts& contacts,
              ThreadPool& threads);
  void record_positions(Particles& particles, const Domain& domain, ThreadPool& threads);
  void transfer_bodies(const class StateTransfer& state, const BodyOrder& order);
  void transfer_crossing(const class StateTransfer& state);
  std::vector<std::uint32_t> order_in_space(int dimension);
  void compare_order(const Contacts& contacts, int dimension);
  void measure(const Particles& particles, const Boundaries& boundaries, ThreadPool& threads);
  SkinChoice::ListStatistics list_statistics(const Particles& particles, const Boundaries& boundaries,
                                             const Contacts& contacts) const;

  double skin_;
  SkinChoice choice_;
  std::uint64_t steps_ = 0;  // since the last search
  Contacts::Lookup lookup_;
  RankShare* share_ = nullptr;
  std::function<void()> bring_others_;
  // Tiles of this rank, in order.
  std::vector<std::uint32_t> own_tiles(std::size_t bodies) const;
  Ranks* ranks() const { return share_ ? &share_->ranks : nullptr; }
  const std::vector<NeighbourPair>& find_pairs(double moved, Particles& particles, const Domain& domain,
                                               ThreadPool& threads);
  // Pairs of the tiles of this rank.
  void find_own_pairs(double moved, Particles& particles, const Domain& domain, ThreadPool& threads);

  RepeatedSearch search_;
  NearBodies near_;          // of several ranks
  double near_covered_ = 0;  // skin (m) within which no body is missing there
  std::vector<NeighbourPair> own_pairs_;
  double body_travel_ = 0, plane_travel_ = 0, surface_travel_ = 0;  // (m) bounds since the last search
  std::vector<double> surface_reach_;
  NearWalls near_walls_;
  BodyColumn<Sphere> bodies_at_search_;  // bodies at the last search
  std::vector<scree_plane> planes_at_search_;
  std::vector<std::uint8_t> absent_at_search_;
  std::uint64_t rebuilds_ = 0;
  double crossing_when_sorted_ = 0;  // share of pairs that cross tiles in the last order that was tried
  std::vector<std::uint32_t> better_order_;
};

}  // namespace scree
