#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <scree/body_range.hpp>
#include <scree/contacts.hpp>
#include <scree/domain.hpp>
#include <scree/onset.hpp>
#include <scree/pair_constants.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_abi.h>
#include <scree/profile.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

// A configured contact law.
struct LawInstance {
  scree_contact_instance interface = {};
  const void* storage = nullptr;
  OnsetWeights touching = {}, parting = {};  // of its forces
};

// What one evaluation of all contacts adds up to. Dissipated columns are of the contacts in which they are
// above 0; those below 0 add up to what the laws create.
struct ContactSums {
  double elastic_normal = 0, elastic_tangential = 0;                                // (J)
  double dissipated_normal = 0, dissipated_tangential = 0, dissipated_rolling = 0;  // (W)
  double dissipated_friction = 0, dissipated_release = 0;                           // (J) in this step
  double created_power = 0;                                                         // (W)
  double created = 0;                                                               // (J) in this step
  double max_overlap_ratio = 0;  // overlap / smaller radius, met so far

  ContactSums& operator+=(const ContactSums& other);
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
    Precision precision = Precision::full;
  };

  explicit Forces(const Features& features);
  ~Forces();

  // To be called for all bodies before an evaluation adds to their loads.
  static void clear(Particles& particles, BodyRange bodies);
  // What comes after the contacts of bodies: called once for each part of BodyTiles, when their loads are
  // whole and no contact that is still to come looks at them.
  using Settle = std::function<void(std::size_t part, unsigned worker)>;
  // Evaluates all contacts: adds to the loads of bodies, sets those of planes; step = 0 does not move
  // springs.
  ContactSums evaluate(Particles& particles, Contacts& contacts, const std::vector<LawInstance>& laws,
                       const std::vector<scree_plane>& planes, std::vector<scree_load>& loads,
                       const Domain& domain, double step, ThreadPool& threads, const Settle& settle,
                       Profile* profile = nullptr);

  // Force on a of pair p at the last evaluation (N), z = 0 in 2D; not numbers if they are not kept.
  Vec3 pair_force(std::size_t p) const;
  std::size_t bytes_per_pair() const;

 private:
  struct Work;
  void follow_pairs(Particles& particles, const Contacts& contacts, std::uint32_t reads, std::size_t planes);
  // Adds the loads that contacts of other tiles have left for the bodies of a part.
  void collect(Particles& particles, std::size_t part) const;
  void sum_loads(const Particles& particles, std::vector<scree_load>& loads) const;

  Features features_;
  std::unique_ptr<Work> work_;
};

}  // namespace scree
