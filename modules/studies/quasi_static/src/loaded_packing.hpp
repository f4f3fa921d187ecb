#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/quasi_static/follow.hpp>
#include <scree/response/quasi_static.hpp>
#include <scree/simulation.hpp>

namespace scree::quasi_static {

// A packing at one time, seen from its walls.
struct Sample {
  double time = 0;  // (s)
  std::vector<scree_plane> planes;
  std::vector<scree_load> loads;
  std::vector<scree_frame> frames;
  std::vector<scree_frame_load> surface_loads;
  std::vector<std::uint8_t> absent;  // of each wall, whether it is not there
  std::size_t contacts = 0, sliding = 0;
  bool dynamic = false;  // reached by dynamics
};

// A packing under the load of the last stage. It is in balance with the load; where it has no equilibrium
// next to the present one, it moves by dynamics until it has. What it does is counted in a FollowedLoad.
class LoadedPacking {
 public:
  // threads: of dynamics. proceed: polled; once it is false, the packing is where it was, and only its state
  // is of use.
  LoadedPacking(const scenario::Plan& plan, unsigned threads, std::function<bool()> proceed,
                FollowedLoad& load);

  // Takes over a simulation at the start of the last stage. Returns false if it is not in balance with the
  // load: then it moves. Throws Error if a law has no derivative, or walls are moved otherwise than by loads.
  bool begin(std::unique_ptr<Simulation> simulation);
  // The same from a state of this class; moves: whether the packing was moving.
  void begin(const State& state, bool moves);

  // To a later time (s). Returns nothing if it was stopped on the way.
  std::optional<Sample> advance(double time);
  Sample sample(double time) const;
  bool moves() const { return moves_; }
  const std::vector<std::string>& surface_names() const;
  State state() const;
  // Begins the search for equilibrium anew, from positions and springs alone, so that a load that goes on
  // from `keep(state)` has the same bits.
  void begin_part(const std::function<void(const State&)>& keep);
  // Adds the counts of the present search to the load, and ends it.
  void end_search();

 private:
  std::unique_ptr<Simulation> simulation_of(const State& state) const;
  bool balance();
  void begin_motion();
  bool move_to(double time);
  std::optional<Sample> seek_balance(double time);

  const scenario::Plan& plan_;
  unsigned threads_;
  std::function<bool()> proceed_;
  FollowedLoad& load_;
  std::unique_ptr<Simulation> simulation_;          // which moves, or from which the search began
  std::unique_ptr<response::QuasiStatic> balance_;  // the search for equilibrium; none while it moves
  bool moves_ = false;
};

}  // namespace scree::quasi_static
