#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <Eigen/Core>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

struct ModeSearch {
  std::size_t count = 20;  // of modes above those that are floppy; 0: only these and unstable ones
  double near_hz = 0;      // above 0: those nearest to this frequency, else the lowest
  std::function<bool()> proceed = [] { return true; };
  std::function<void(double share, const std::string& what)> on_progress = [](double, const std::string&) {};
};

// Some modes of a system without damping, in ascending order: unstable ones (ω² < 0), floppy ones (ω² = 0 within
// round-off), then those that vibrate. The latter are modes of the symmetric part of K, the others of all of K.
struct FoundModes {
  std::size_t unstable = 0, floppy = 0;  // of the system: by the inertia of K, then with its asymmetry
  bool counted = false;                  // whether `floppy` is known; not after an early end of the search
  std::size_t first_floppy = 0,
              first_vibrating = 0;   // among the columns; all unstable ones are found up to 200
  Eigen::VectorXd square_frequency;  // ω² (1/s²)
  Eigen::MatrixXd shape;             // q, normalised to qᵀ M q = 1
  // |K q − ω² M q| in the coordinates √M q, with the full K, over ω², or for floppy modes over UndampedSystem::rounding().
  Eigen::VectorXd residual;
  // Whether the inertia confirms that among the vibrating modes none is left out; false too where all found are equal.
  bool complete = false;
  // Whether unstable and floppy modes are those of all of K; where its asymmetry is too large (sliding contacts), or there are too
  // many, they are those of its symmetric part, of which some may be neither.
  bool of_full_stiffness = true;
};

// By shift and invert with block Lanczos iteration. Fewer modes than asked for where `proceed` ends the search, or
// where the system has no more.
FoundModes find_modes(const UndampedSystem& system, const ModeSearch& search);

}  // namespace scree::response
