#include <algorithm>
#include <string_view>

#include <scree/charts/text_fit.hpp>

namespace scree::charts {
namespace {

// The first `bytes` of a line, without splitting a UTF-8 character, and an ellipsis.
std::string beginning(const std::string& line, std::size_t bytes) {
  while (bytes > 0 && (line[bytes] & 0xC0) == 0x80) --bytes;
  return line.substr(0, bytes) + "...";
}

// Bytes of the UTF-8 character at the start of a text; 0 if there is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? unsigned(text[k]) & 0xFFu : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  const bool too_long = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool too_large = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
  return too_long || too_large ? 0 : size;
}

}  // namespace

std::string drawable_text(const std::string& text) {
  std::string drawable;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t size = character_size(std::string_view(text).substr(k));
    const bool is_control = std::size_t(static_cast<unsigned char>(text[k])) < 0x20 || text[k] == 0x7F;
    drawable += size == 0 ? "?" : is_control ? " " : text.substr(k, size);
    k += size == 0 ? 1 : size;
  }
  return drawable;
}

std::string shown_part(const std::string& line) {
  constexpr std::size_t longest = 400;  // bytes
  return line.size() > longest ? beginning(line, longest) : line;
}

FittedText fit_text(const std::string& whole, double size, double room, const TextWidth& width) {
  const std::string line = shown_part(whole);
  if (const double wide = width(line, size); wide > room) size *= std::max(2.0 / 3, room / wide);
  const auto fits = [&](const std::string& text) { return width(text, size) <= 1.02 * room; };
  if (fits(line)) return {line, size};
  std::size_t fitting = 0, too_long = line.size();
  while (too_long - fitting > 1) {
    const std::size_t middle = (fitting + too_long) / 2;
    (fits(beginning(line, middle)) ? fitting : too_long) = middle;
  }
  return {beginning(line, fitting), size};
}

}  // namespace scree::charts
