#pragma once

#include "tone.hpp"

#include <optional>
#include <vector>

namespace scree::spectrum {

// The halves of the analysed periods of a tone: where their responses differ, the motion is not steady.
class ToneHalves {
 public:
  // middle: (s) since the start of the frequency. Records that are too short have no halves.
  ToneHalves(const scenario::SpectrumPlan& plan, double frequency, double middle);

  // As Tone::add.
  void add(double time, double drive, const std::vector<double>& values);
  // Whether one of the first columns changes by more than spectrum.tolerance of its response, or of its scale if that is more, and by
  // more than errors explain.
  bool differ(const std::vector<double>& scales) const;

 private:
  const scenario::SpectrumPlan& plan_;
  double middle_;
  std::optional<Tone> first_, second_;
};

}  // namespace scree::spectrum
