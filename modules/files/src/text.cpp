#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::files {

std::string one_line(std::string_view text, std::size_t longest) {
  std::string_view kept = text;
  if (text.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    kept = text.substr(0, end);
  }
  std::string result;
  for (const char c : kept) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n') {
      result += "\\n";
    } else if (c == '\r') {
      result += "\\r";
    } else if (c == '\t') {
      result += "\\t";
    } else if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\x{:02X}", code);
    } else {
      result += c;
    }
  }
  return kept.size() < text.size() ? result + "..." : result;
}

}  // namespace scree::files
