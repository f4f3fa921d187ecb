#pragma once

#include <complex>
#include <limits>
#include <vector>

namespace scree::spectrum {

// The displacement of layers from one end of a packing to the other in a steady motion.
struct ModeShape {
  // In the phase in which the layers move most, over the largest; its sign is such that the largest is above 0.
  std::vector<double> displacement;
  // Wavelengths between the ends, the nearest of 0.25, 0.5, 0.75, ...: of the sine of any phase that fits the
  // displacements best among those with as many nodes, or one more beyond an end. So a wall that moves by itself
  // makes no antinode. NaN if there is no standing wave: the wave that comes back from an end has less than a quarter
  // of the amplitude of that which goes there.
  double wavelengths = std::numeric_limits<double>::quiet_NaN();
};

// Of three layers or more. Layers that move less than a tenth of the largest displacement are in no phase.
ModeShape mode_shape(const std::vector<std::complex<double>>& layers);

}  // namespace scree::spectrum
