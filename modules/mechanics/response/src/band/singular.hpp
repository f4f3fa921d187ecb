#pragma once

#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::response {

// Why there is no response at a frequency.
inline Error singular_at(double frequency_hz) {
  return Error(
      frequency_hz == 0
          ? std::string(
                "the response at 0 Hz is infinite: no contact resists some motion, such as that of bodies "
                "with too few contacts; compress the packing, give a larger fewest_contacts, or take a "
                "frequency above 0")
          : fmt::format(
                "the response at {:g} Hz is infinite: an undamped mode has this frequency, or bodies with too "
                "few contacts move freely; add damping, give a larger fewest_contacts, or take another "
                "frequency",
                frequency_hz));
}

}  // namespace scree::response
