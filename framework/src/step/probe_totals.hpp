#pragma once

#include "machine/exact_sum.hpp"
#include "step/simulation_parts.hpp"

#include <cstdint>
#include <vector>

#include <scree/probes.hpp>

namespace scree {

// Adds up the totals of a probe over the tiles of all ranks.
class ProbeTotals {
 public:
  // walls: what a view shows of walls; must outlive this.
  ProbeTotals(SimulationParts& parts, const Probe& probe, const scree_view& walls);
  // Called by all ranks. Throws Error if the plug-in fails.
  std::vector<double> all();

 private:
  // What one worker has added.
  struct Partial {
    std::vector<ExactSum> sums;
    std::vector<double> largest;

    void add(const std::vector<double>& of_tile);
    void add(const Partial& other);
  };
  void count_contacts();
  std::vector<double> of_pass(std::uint32_t pass, const std::vector<double>& before);
  std::vector<double> of_tile(std::size_t tile, std::uint32_t pass, const std::vector<double>& before) const;
  std::vector<double> over_ranks(const Partial& own);

  SimulationParts& parts_;
  const Probe& probe_;
  scree_view part_;                     // without the bodies that count and the contacts
  std::vector<std::uint8_t> left_out_;  // by place
  BodyColumn<std::uint32_t> contacts_of_body_;
};

}  // namespace scree
