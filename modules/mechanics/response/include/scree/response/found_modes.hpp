#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <Eigen/Core>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

// Free motions without damping, q = shape cos(ωt): as many as there are masses above 0. Walls without mass
// follow the bodies at once.
struct Modes {
  Eigen::VectorXd square_frequency;  // ω² (1/s²), ascending; below 0: the packing is unstable
  Eigen::MatrixXd shape;             // one column each, normalised to shapeᵀ M shape = 1
  // |K − Kᵀ|/|K| in mass-weighted coordinates √M q. The modes belong to the symmetric part of K.
  double asymmetry;
};

// Computes all modes with a dense solver; for systems of up to some thousand degrees of freedom.
Modes modes_of(const LinearSystem& system);

struct ModeSearch {
  std::size_t count = 20;  // vibrating modes; 0: only floppy and unstable modes
  double near_hz = 0;      // above 0: the modes nearest to this frequency; 0: the lowest modes
  std::function<bool()> proceed = [] { return true; };
  std::function<void(double share, const std::string& what)> on_progress = [](double, const std::string&) {};
};

// Some modes of a system without damping, in ascending order: unstable modes (ω² < 0), floppy modes (ω² = 0
// within round-off), then vibrating modes. Vibrating modes belong to the symmetric part of K, the others to
// the full K.
struct FoundModes {
  std::size_t unstable = 0, floppy = 0;  // in the whole system: by the inertia of K, then with its asymmetry
  bool counted = false;                  // whether `floppy` is known: false after an early end of the search
  bool certain = true;                   // whether all counts are, see ModeCount
  std::size_t first_floppy = 0,
              first_vibrating = 0;   // columns; all unstable modes are computed up to 200
  Eigen::VectorXd square_frequency;  // ω² (1/s²)
  Eigen::MatrixXd shape;             // q, normalised to qᵀ M q = 1
  // |K q − ω² M q|/ω² in the coordinates √M q, with the full K; for floppy modes over
  // UndampedSystem::rounding().
  Eigen::VectorXd residual;
  // Whether the inertia confirms that no vibrating mode is left out; false also if all found modes are equal.
  bool complete = false;
  // Whether unstable and floppy modes belong to the full K. If its asymmetry is too large (sliding contacts),
  // or there are too many of them, they belong to the symmetric part, and some may be neither with the full
  // K.
  bool of_full_stiffness = true;
};

// Finds modes by block Lanczos iteration with shift and invert. Returns fewer modes than asked for if
// `proceed` ends the search, or if the system has no more.
FoundModes find_modes(const UndampedSystem& system, const ModeSearch& search);

}  // namespace scree::response
