#pragma once

#include <string>
#include <string_view>

#include <scree/charts/chart_spec.hpp>

namespace scree::charts {

// Incremented when this interface or a struct in it changes; loader and library must have the same version.
inline constexpr int backend_version = 2;

// Draws charts. Not thread-safe.
class ChartBackend {
 public:
  virtual ~ChartBackend() = default;

  // The bytes of a file in one of chart_formats. Throws scree::Error.
  virtual std::string draw(const ChartSpec& spec, std::string_view format) = 0;
};

}  // namespace scree::charts
