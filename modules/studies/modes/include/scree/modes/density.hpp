#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <scree/response/undamped_system.hpp>

namespace scree::modes {

// Modes between two frequencies.
struct DensityPoint {
  double from_hz, to_hz;
  std::size_t modes, below;  // between them; below `to_hz`, without unstable and floppy ones
  double density;            // modes per Hz and body
  double reduced;            // in 3D over the square of the middle frequency (1/Hz³), in 2D over it (1/Hz²)
  bool certain;              // whether the counts are, see response::ModeCount
};

struct DensityOptions {
  unsigned points = 50;
  double to_hz = 0;  // 0: above all modes
  unsigned threads = 1;
  std::function<bool()> proceed = [] { return true; };
  std::function<void(double share, const std::string& what)> on_progress = [](double, const std::string&) {};
};

// The density of states at equal steps, by the inertia of K − ω²M. Up to where `proceed` ends it.
std::vector<DensityPoint> density_of_states(const response::UndampedSystem& system, std::size_t bodies,
                                            const DensityOptions& options);

}  // namespace scree::modes
