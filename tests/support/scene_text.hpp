#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace scree::test {

// Nine discs in a fixed box, as text; ten steps.
inline constexpr const char* discs =
    "[scene]\n"                                                               // 1
    "dimension = 2\n"                                                         // 2
    "[time]\n"                                                                // 3
    "step = 1e-5\n"                                                           // 4
    "duration = 1e-4\n"                                                       // 5
    "[[material]]\n"                                                          // 6
    "name = 'grain'\n"                                                        // 7
    "density = 1000\n"                                                        // 8
    "[[contact]]\n"                                                           // 9
    "plugin = 'linear_spring_dashpot'\n"                                      // 10
    "normal_stiffness = 1e4\n"                                                // 11
    "normal_damping = 0\n"                                                    // 12
    "[particles]\n"                                                           // 13
    "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n"              // 14
    "radius = 0.01\n"                                                         // 15
    "random_velocity = 0.1\n"                                                 // 16
    "[[boundary]]\n"                                                          // 17
    "plugin = 'box'\n"                                                        // 18
    "x_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\ny_high = 'fixed'\n"  // 19 to 22
    "gap = 0.005\n"                                                           // 23
    "[[probe]]\n"                                                             // 24
    "plugin = 'energy'\n"                                                     // 25
    "every = 2e-5\n";                                                         // 26

// Returns the text with the first occurrence of a part replaced.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace scree::test
