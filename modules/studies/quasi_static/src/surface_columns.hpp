#pragma once

#include "loaded_packing.hpp"

#include <string>
#include <vector>

#include <scree/state_transfer.hpp>

namespace scree::quasi_static {

// Columns of a series about the surfaces that forces move: displacement along the direction of the force
// since the start of the load (m), and the force with which the surface presses the bodies along it (N).
class SurfaceColumns {
 public:
  SurfaceColumns() = default;
  // Those that forces move in the present stage.
  explicit SurfaceColumns(const Simulation& simulation);

  void begin(const Sample& start);
  bool empty() const { return surfaces_.empty(); }
  std::vector<std::string> names() const;
  std::vector<double> numbers(const Sample& sample) const;
  const std::string& first_name() const { return surfaces_.front().name; }
  // All but names.
  void transfer(const StateTransfer& state);
  // Sets names of what a state has, which must have no other surfaces than the scene.
  void restore(const StateTransfer& state, const std::vector<std::string>& names);

 private:
  struct Moved {
    std::string name;
    std::size_t number;  // among the surfaces of the scene
    Vec3 direction, at_start = {};
  };
  std::vector<Moved> surfaces_;
};

}  // namespace scree::quasi_static
