#pragma once

#include "bodies/body_range.hpp"
#include "contacts/contact_sums.hpp"
#include "contacts/contacts.hpp"
#include "contacts/onset.hpp"
#include "contacts/pair_constants.hpp"
#include "ranks/rank_sums.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/plugin/abi.h>
#include <scree/profile.hpp>
#include <scree/thread_pool.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

struct RankShare;

// A configured contact law.
struct LawInstance {
  scree_contact_instance interface = {};
  const void* storage = nullptr;
  OnsetWeights touching = {}, parting = {};  // weights of its forces at first touch and at parting
};

// Bits of the inputs that any law reads, and of the inputs from which these are computed.
std::uint32_t reads_of(const std::vector<LawInstance>& laws);

// Evaluates all contacts in tiles of bodies: gather -> geometry -> law -> scatter, in blocks of pairs.
// Every sum has a fixed order, so that results have the same bits for any number of threads.
class Forces {
 public:
  struct Features {
    int dimension = 3;
    bool spin = false;  // bodies carry spin, contacts exert torques
    bool periodic = false;
    bool audit = true;          // laws report energies
    bool pair_forces = true;    // per-contact forces are stored
    bool sliding_work = false;  // see keep_sliding_work
  };

  explicit Forces(const Features& features);
  ~Forces();

  // Input and output of one evaluation: adds to the loads of bodies, sets the loads of planes.
  struct Evaluation {
    Particles& particles;
    Contacts& contacts;
    const std::vector<LawInstance>& laws;
    const std::vector<scree_plane>& planes;
    std::vector<scree_load>& loads;  // (planes)
    const WallSurfaces& surfaces;
    std::vector<scree_frame_load>& frame_loads;  // (surfaces)
    const Domain& domain;
    double elapsed;  // (s) since the last evaluation, by which springs advance
    double kick;     // (s) for which the forces act on the bodies; 0: not at all
  };
  // Runs once per part of BodyTiles, after all its contact loads are summed and no remaining tile reads its
  // bodies.
  using FinishPart = std::function<void(std::size_t part, unsigned worker)>;

  const Features& features() const { return features_; }
  // From now on several ranks compute the scene: evaluates the pairs of the tiles of this rank alone.
  void share_with_ranks(RankShare& share);
  // Sets the loads of bodies to 0; must be called for all bodies before an evaluation.
  static void clear(Particles& particles, BodyRange bodies);
  // Evaluates all pairs, or those of this rank. Loads of planes and `total` are set when `sums` is closed.
  void evaluate(const Evaluation& evaluation, ThreadPool& threads, const FinishPart& finish_part,
                RankSums& sums, ContactSums& total, Profile* profile = nullptr);

  // Bodies of other ranks that pairs of this rank read, and bytes that it sends in an evaluation.
  struct Foreign {
    std::size_t bodies, bytes_sent;
  };
  Foreign foreign() const;
  // Brings records of bodies of other ranks that pairs of this rank read, between evaluations.
  void bring_bodies_of_others(Particles& particles);
  // Adds what this rank has counted of these bodies, by place, to the counts of their ranks.
  void return_counts(BodyColumn<std::uint32_t>& counts);

  // Makes room for the listed pairs, as an evaluation does first; their forces are 0.
  void update_pairs(Particles& particles, const Contacts& contacts, std::uint32_t reads, std::size_t planes,
                    ThreadPool& threads);

  // Forces of pairs in the last evaluation, and the largest overlap so far; `forces` if these are pairs of
  // all ranks.
  void save(const class StateTransfer& state, const BodyOrder& order, const Contacts& contacts,
            PairColumns& forces) const;
  void restore(const class StateTransfer& state, Particles& particles, const Contacts& contacts,
               const std::vector<LawInstance>& laws, std::size_t planes, ThreadPool& threads);

  // Begins to add up what friction dissipates on surfaces, which the features must allow. Throws Error if one
  // is infinite.
  void keep_sliding_work(const WallSurfaces& surfaces);
  // Null if it is not kept; of several ranks, each has its part.
  class SlidingWork* sliding_work();

  // Whether a state has the forces of pairs.
  static bool are_in(const class State& state);

  // Whether the last evaluation was of these pairs.
  bool are_of(const Contacts& contacts) const;
  // Force on a of each pair in the last evaluation (N); no columns if pair forces are not stored.
  PairColumns& pair_forces();
  std::uint32_t columns() const { return features_.pair_forces ? std::uint32_t(features_.dimension) : 0; }
  std::size_t bytes_per_pair() const;

 private:
  struct Work;
  // Adds the loads that other tiles have computed for the bodies of a part.
  void collect(Particles& particles, std::size_t part) const;
  void sum_load(double& load, const Particles& particles, std::size_t wall, std::size_t k,
                RankSums& sums) const;
  void sum_loads(const Particles& particles, std::vector<scree_load>& loads, RankSums& sums) const;
  void sum_frame_loads(const Particles& particles, std::size_t planes, std::vector<scree_frame_load>& loads,
                       RankSums& sums) const;
  void place_surfaces(const Evaluation& evaluation);

  Features features_;
  RankShare* share_ = nullptr;
  std::unique_ptr<Work> work_;
};

}  // namespace scree
