#pragma once

#include <cstdint>
#include <limits>

#include <scree/plugin/abi.h>

namespace scree {

// A column of another probe that a probe reads, declared by Declaration::input. The host takes its values at
// each observation and sample of the reader, after the other probe has observed.
struct InputColumn {
  const char* name = nullptr;  // "<probe>.<column>"; null if it is not given
  const char* unit = nullptr;
  std::uint32_t number = 0;  // among the inputs of the probe

  // At the time of the view; NaN in `start`.
  double value(const scree_view& view) const {
    return number < view.input_count ? view.inputs[number] : std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace scree
