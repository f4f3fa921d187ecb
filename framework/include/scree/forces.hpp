#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <scree/contacts.hpp>
#include <scree/domain.hpp>
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
};

// What one evaluation of all contacts adds up to.
struct ContactSums {
  double elastic_normal = 0, elastic_tangential = 0;        // (J)
  double dissipated_normal = 0, dissipated_tangential = 0;  // (W)
  double dissipated_friction = 0;                           // (J) in this step
  double max_overlap_ratio = 0;                             // overlap / smaller radius
};

// Evaluates all contacts in tiles of bodies: gather -> law -> scatter in blocks of pairs.
// Every sum has a fixed order, so that results have the same bits for any number of threads.
class Forces {
 public:
  struct Features {
    int dimension = 3;
    bool spin = false;  // bodies carry spin, contacts make torques
    bool periodic = false;
    bool audit = true;  // laws report energies
    Precision precision = Precision::full;
  };

  explicit Forces(const Features& features);
  ~Forces();

  // Sets force and torque of all bodies and loads of all planes; step = 0 evaluates without moving springs.
  ContactSums evaluate(Particles& particles, Contacts& contacts, const std::vector<LawInstance>& laws,
                       const std::vector<scree_plane>& planes, std::vector<scree_load>& loads,
                       const Domain& domain, double step, ThreadPool& threads, Profile* profile = nullptr);

  // Force on a of pair p at the last evaluation (N), z = 0 in 2D.
  Vec3 pair_force(std::size_t p) const;
  std::size_t bytes_per_pair() const;
  std::size_t bytes_per_body() const;

 private:
  struct Work;
  void follow_pairs(const Particles& particles, const Contacts& contacts, std::uint32_t reads,
                    std::size_t planes);
  void finish_tile(std::size_t tile, Particles& particles);
  void sum_loads(std::vector<scree_load>& loads) const;

  Features features_;
  std::unique_ptr<Work> work_;
};

}  // namespace scree
