#include "nearest_name.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/nearest.hpp>

namespace scree::packing {

std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known) {
  const auto near = nearest_word(unknown, {known.begin(), known.end()});
  return near ? fmt::format("did you mean '{}'?", *near)
              : fmt::format("known are {}", fmt::join(known, ", "));
}

}  // namespace scree::packing
