#pragma once

#include "bodies/body_range.hpp"
#include "contacts/contact_sums.hpp"
#include "contacts/contacts.hpp"
#include "contacts/onset.hpp"
#include "contacts/pair_constants.hpp"
#include "threads/thread_pool.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/plugin/abi.h>
#include <scree/profile.hpp>

namespace scree {

// A configured contact law.
struct LawInstance {
  scree_contact_instance interface = {};
  const void* storage = nullptr;
  OnsetWeights touching = {}, parting = {};  // of its forces
};

// Evaluates all contacts in tiles of bodies: gather -> law -> scatter in blocks of pairs.
// Every sum has a fixed order, so that results have the same bits for any number of threads.
class Forces {
 public:
  struct Features {
    int dimension = 3;
    bool spin = false;  // bodies carry spin, contacts make torques
    bool periodic = false;
    bool audit = true;        // laws report energies
    bool pair_forces = true;  // those of pairs are kept
    Precision precision = Precision::double_precision;
  };

  explicit Forces(const Features& features);
  ~Forces();

  // What one evaluation works on: the loads of bodies are added to, those of planes set.
  struct Evaluation {
    Particles& particles;
    Contacts& contacts;
    const std::vector<LawInstance>& laws;
    const std::vector<scree_plane>& planes;
    std::vector<scree_load>& loads;  // (planes)
    const Domain& domain;
    double elapsed;  // (s) since the last evaluation; 0 moves no spring
  };
  // Runs once per part of BodyTiles, after all its contact loads are summed and no remaining tile reads its
  // bodies.
  using FinishPart = std::function<void(std::size_t part, unsigned worker)>;

  // To be called for all bodies before an evaluation adds to their loads.
  static void clear(Particles& particles, BodyRange bodies);
  ContactSums evaluate(const Evaluation& evaluation, ThreadPool& threads, const FinishPart& finish_part,
                       Profile* profile = nullptr);

  // Force on a of pair p at the last evaluation (N), z = 0 in 2D; not numbers if they are not kept.
  Vec3 pair_force(std::size_t p) const;
  std::size_t bytes_per_pair() const;

 private:
  struct Work;
  void update_pairs(Particles& particles, const Contacts& contacts, std::uint32_t reads, std::size_t planes);
  // Adds the loads that contacts of other tiles have left for the bodies of a part.
  void collect(Particles& particles, std::size_t part) const;
  void sum_loads(const Particles& particles, std::vector<scree_load>& loads) const;

  Features features_;
  std::unique_ptr<Work> work_;
};

}  // namespace scree
