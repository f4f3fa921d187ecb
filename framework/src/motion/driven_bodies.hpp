#pragma once

#include "bodies/body_range.hpp"
#include "motion/integrator.hpp"

#include <span>
#include <vector>

#include <scree/plugin/program.hpp>
#include <scree/scene.hpp>

namespace scree {

// Held components of bodies, which follow their function of time or keep their velocity, and loads of groups.
// It acts around the integrator's halves of a step, on these bodies alone: the integrator finds no load on a
// held component, and the velocity that moves it by ∫u dt. Work: Δ(½ m u²) − ∫F u dt of what holds a
// component, as walls do it, and ∫F v dt of the loads of groups.
class DrivenBodies {
 public:
  // Sets the velocities of components that follow a function of time to those at t = 0. Without the bodies of
  // the scene nothing is held or loaded before a transfer.
  DrivenBodies(const Scene& scene, Particles& particles);
  // What is held and loaded, by place.
  void transfer(const class StateTransfer& state, std::size_t bodies);

  // Whether it acts on a body, or on one of a part (see BodyTiles).
  bool any() const { return !held_.entries.empty() || !loaded_.entries.empty(); }
  bool any_in(std::size_t part) const {
    return any() && !(held_.of(part).empty() && loaded_.of(part).empty());
  }

  // Moves the bodies in memory, see Particles::rearrange.
  void rearrange(const std::vector<std::uint32_t>& from);

  // A step from `time`, and the evaluation of forces in it, `elapsed` after the last one at `force_time` (s).
  struct Times {
    double time, step, force_time, elapsed;
    bool mid_step;  // the evaluation is halfway, to where the first half of the step moves the bodies
  };
  // Called once before the parts begin a step, or evaluate and finish it.
  void plan_begin(const Times& times);
  void plan_finish(const Times& times);

  // The integrator's functions of the same names.
  void prepare(Integrator& integrator, Particles& particles, double step, std::span<const BodyRange> bodies);
  double begin_step(Integrator& integrator, Particles& particles, double step, BodyRange bodies,
                    std::size_t part);
  bool finish_step(Integrator& integrator, Particles& particles, double step, BodyRange bodies,
                   std::size_t part);
  // After the bodies of a part have moved to the evaluation, before their loads are cleared: sets the
  // velocities of held components there. Returns the work (J) of the loads before it.
  double predict(Particles& particles, std::size_t part) const;
  // Adds the loads of groups after an evaluation.
  void add_loads(Particles& particles, std::size_t part) const;
  // The work (J) of the loads after it.
  double work(Particles& particles, std::size_t part) const;

 private:
  // A component of a body with one of the functions of time, or without one a constant speed.
  struct Entry {
    static constexpr std::uint32_t no_function = ~std::uint32_t(0);
    std::uint32_t body;
    int component;
    std::uint32_t function = no_function;
    double speed = 0;
  };
  // Entries in the order of bodies.
  struct Entries {
    std::vector<Entry> entries;
    std::vector<std::size_t> first;  // of each part, and the end

    void sort(std::size_t bodies);
    void transfer(const class StateTransfer& state, std::size_t bodies);
    void rearrange(const std::vector<std::uint32_t>& to);
    std::span<const Entry> of(std::size_t part) const {
      return {entries.data() + first[part], first[part + 1] - first[part]};
    }
  };
  // Of held components.
  struct Drive {
    Program program;
    bool displacement = false;  // else of velocity

    double distance(double time, double step) const;
    double speed(double time) const;
  };
  // A drive in a step.
  struct Pace {
    double part_speed;            // mean while the half of the step moves the bodies
    double distance, mean_speed;  // since the last evaluation
    double speed, end_speed;      // at the evaluation, and at the end of the step
    double gain;                  // u² at the evaluation less u² at the last one
  };
  // What functions are in a step that begins, or in one that finishes.
  struct Planned {
    Times times = {};
    std::vector<Pace> paces;
    std::vector<double> loads;  // at the last evaluation where a step begins, at its own where it finishes
  };

  void add_functions(const BodyGroup& group, freedom::Mask carried, std::vector<freedom::Mask>& driven);
  void plan_paces(const Times& times, Planned& planned) const;
  Pace pace(const Entry& entry, const Planned& planned) const;
  void set_aside(Particles& particles, std::span<const Entry> entries);
  void put_back(Particles& particles, std::span<const Entry> entries) const;

  Entries held_, loaded_;
  std::vector<Drive> drives_;
  std::vector<Program> loads_;
  Planned begun_, finished_;
  std::vector<double> aside_;  // loads of held components while the integrator moves the bodies
};

}  // namespace scree
