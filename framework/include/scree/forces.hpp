#pragma once

#include <cstddef>
#include <vector>

#include <scree/column.hpp>
#include <scree/contacts.hpp>
#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_abi.h>
#include <scree/thread_pool.hpp>

namespace scree {

namespace kernel {
struct Scene;
}

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

// Evaluates all contacts: gather -> law -> scatter in blocks, then the sum over each body's contacts.
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

  explicit Forces(const Features& features) : features_(features) {}

  // Sets force and torque of all bodies and loads of all planes; step = 0 evaluates without moving springs.
  ContactSums evaluate(Particles& particles, Contacts& contacts, const std::vector<LawInstance>& laws,
                       const std::vector<scree_plane>& planes, std::vector<scree_load>& loads,
                       const Domain& domain, double step, ThreadPool& threads);

  // Force on a of pair p at the last evaluation (N), z = 0 in 2D.
  Vec3 pair_force(std::size_t p) const;
  std::size_t bytes_per_pair() const;

 private:
  struct Block {
    PairGroup* group;
    std::size_t begin;  // in the group
    std::uint32_t count;
  };
  void plan_blocks(Contacts& contacts);
  template <class T>
  void evaluate_blocks(const kernel::Scene& scene, const std::vector<LawInstance>& laws, ThreadPool& threads);

  Features features_;
  std::vector<Block> blocks_;
  std::vector<ContactSums> block_sums_;
  Column<double> records_;  // (pairs, record width): force on a, torque on a, torque on b
};

}  // namespace scree
