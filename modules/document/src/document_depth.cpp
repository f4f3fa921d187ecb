#include "document_depth.hpp"

namespace scree::document {
namespace {

// Well above what is refused later with an exact place, well below what a stack holds.
constexpr int most_parts = 1000;

bool is_key_character(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
         c == '"' || c == '\'' || code >= 0x80;
}

// Counts the dots of one chain of words, such as a.b . "c"; two words without a dot between begin a new
// chain.
class Chain {
 public:
  int take(char c) {
    if (c == ' ' || c == '\t') {
      gap_ = true;
      return dots_;
    }
    const bool word = is_key_character(c);
    const bool joined = c == '.' ? last_is_word_ : word && (!last_is_word_ || !gap_);
    dots_ = joined ? dots_ + (c == '.') : 0;
    last_is_word_ = word;
    gap_ = false;
    return dots_;
  }

 private:
  int dots_ = 0;
  bool last_is_word_ = false;
  bool gap_ = false;
};

}  // namespace

std::optional<Place> find_endless_key(std::string_view text) {
  Chain chain;
  std::uint32_t line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (chain.take(c) > most_parts) return Place{line, 1};
  }
  return std::nullopt;
}

}  // namespace scree::document
