#pragma once

#include <string>

namespace scree::test {

// A disc of 1 kg between two walls, pressed by both; one of them oscillates. The springs are linear while
// both touch.
inline const std::string oscillator =
    "[scene]\ndimension = 2\n[time]\nstep = 2e-4\nduration = 3.5\n"
    "[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 10\ntension = 'allowed'\n"
    "[[particle]]\nposition = [0, 0]\nradius = 0.01\nmass = 1\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'left'\npoint = [-0.0099, 0]\nnormal = [1, 0]\n"
    "displacement = { wave = 'sine', amplitude = 1e-6, frequency_hz = 20, phase_deg = 30 }\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'right'\npoint = [0.0099, 0]\nnormal = [-1, 0]\n"
    "[[probe]]\nplugin = 'particles'\nids = [1]\nevery = 0.5\n"
    "[[probe]]\nplugin = 'lock_in'\nname = 'response'\nof = 'particles.x_1'\nfrequency_hz = 20\nfrom = 2.5\nperiods = 20\n"
    "every = 0.5\n"
    "[[expect]]\nrequirement = 'amplitude'\nquantity = 'response.amplitude.last'\nat_least = 0\n"
    "[[expect]]\nrequirement = 'phase'\nquantity = 'response.phase.last'\nat_least = -4\n"
    "[[expect]]\nrequirement = 'samples'\nquantity = 'response.samples.last'\nat_least = 1\n"
    "[[expect]]\nrequirement = 'residual'\nquantity = 'response.residual.last'\nat_least = 0\n";

}  // namespace scree::test
