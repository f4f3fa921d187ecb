#include "embedded_fonts.hpp"

// SCREE_CHART_FONTS: folder of the files when this is compiled.
asm(R"(
.section .rodata
scree_regular_font: .incbin ")" SCREE_CHART_FONTS R"(/DejaVuSans.ttf"
scree_regular_font_end:
scree_bold_font: .incbin ")" SCREE_CHART_FONTS R"(/DejaVuSans-Bold.ttf"
scree_bold_font_end:
.previous
)");

extern "C" {
__attribute__((visibility("hidden"))) extern const char scree_regular_font[];
__attribute__((visibility("hidden"))) extern const char scree_regular_font_end[];
__attribute__((visibility("hidden"))) extern const char scree_bold_font[];
__attribute__((visibility("hidden"))) extern const char scree_bold_font_end[];
}

namespace scree::charts {

std::string_view regular_font() { return {scree_regular_font, scree_regular_font_end}; }
std::string_view bold_font() { return {scree_bold_font, scree_bold_font_end}; }

}  // namespace scree::charts
