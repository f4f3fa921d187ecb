#pragma once

#include "surfaces/facets.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <scree/wall_surfaces.hpp>

namespace scree {

class Ranks;
class StateTransfer;

// The energy that friction has dissipated on each facet of all surfaces since the start. Sums are fixed-point
// numbers, so that neither the order of the contacts nor the rank that adds them changes a bit.
class SlidingWork {
 public:
  // What a contact adds.
  struct Slip {
    std::uint32_t surface, facet;
    double energy;  // (J)
  };

  // Throws Error if a surface is infinite.
  SlidingWork(const WallSurfaces& surfaces, int dimension);

  const Facets& facets(std::size_t surface) const { return facets_[surface]; }
  void add(const Slip& slip);
  // (J) of each facet of a surface.
  std::vector<double> of(std::size_t surface) const;
  // Gives the first rank what all ranks have added.
  void gather(Ranks& ranks);
  void clear();
  void transfer(const StateTransfer& state);

 private:
  __extension__ typedef __int128 Fixed;
  // 32-bit digits of a sum, the last with its sign: those of several ranks are added up.
  static constexpr std::size_t digit_count = 4;
  static std::array<std::int64_t, digit_count> digits_of(Fixed sum);
  static Fixed sum_of(const std::int64_t* digits);
  std::vector<std::int64_t> digits() const;
  void set(const std::vector<std::int64_t>& digits);

  std::vector<Facets> facets_;
  std::vector<std::size_t> first_;  // of the sums of each surface, and behind the last one
  std::vector<Fixed> sums_;
};

}  // namespace scree
