#pragma once

#include <string_view>

namespace scree::charts {

// The bytes of the font files DejaVuSans.ttf and DejaVuSans-Bold.ttf, part of this library, so that a chart
// has the same letters on every machine.
std::string_view regular_font();
std::string_view bold_font();

}  // namespace scree::charts
