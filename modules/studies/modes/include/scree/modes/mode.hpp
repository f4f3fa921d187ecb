#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree::modes {

enum class ModeKind { unstable, floppy, vibrating };

inline constexpr const char* mode_kind_names[] = {"unstable", "floppy", "vibrating"};

// A body that moves in a mode, and its share of the kinetic energy.
struct Participant {
  std::uint32_t body;
  double share;
};

// What one mode is like. Shares are of its kinetic energy.
struct Mode {
  ModeKind kind;
  int number = 0;           // among those of its kind, from 1
  double square_frequency;  // ω² (1/s²); below 0: it grows
  double frequency_hz;      // of those that vibrate, else 0
  double residual;          // FoundModes::residual
  double participation;  // (Σ e)²/(N Σ e²), e: kinetic energy of each of N held bodies; 1: all move alike
  double rotation;       // share of rotations
  std::array<double, 3> direction;        // shares of translations along x, y, z
  double walls;                           // share of walls with mass that move along a direction
  double turns;                           // share of walls with inertia that turn
  double damping_rate;                    // qᵀ C q/qᵀ M q (1/s), by which the energy decays
  std::vector<Participant> participants;  // at most 5, those that move most, from a hundredth on
};

}  // namespace scree::modes
